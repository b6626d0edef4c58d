// Tables of numbers that can be copied, and the report's tables on the screen.
#pragma once

#include <QTableWidget>

#include "engine/report/document.h"

namespace lathelier {

/// Rows are copied as tab-separated text, by Ctrl+C or the context menu.
class CopyTable : public QTableWidget {
    Q_OBJECT

public:
    explicit CopyTable(QWidget* parent = nullptr);
    QString text(bool selectedOnly) const;
    void copyToClipboard() const;

    void setTable(const report::Table& table);
    void setQuantities(const report::Document& document);  ///< all quantity tables of a document, one below the other
    int sizeHintForColumn(int column) const override;
    void fitCells();

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
};

/// A read-only cell; numbers are right-aligned.
QTableWidgetItem* tableCell(const QString& text, bool number);

}  // namespace lathelier
