// A table of rows that a person edits: the segments of a shaft, the rods of a measurement.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "engine/core/fields.h"

class QTableWidget;
class QToolButton;

namespace lathelier {

/// Edits Rows by the columns of their description. Rows are added, removed, and pasted from a spreadsheet
/// (tab-separated cells, from the current cell on). A cell that does not fit is marked with a symbol and says why in
/// its tooltip; the rows count, and are announced, once all cells fit.
class RowsEdit : public QWidget {
    Q_OBJECT
public:
    explicit RowsEdit(const FieldInfo& info, QWidget* parent = nullptr);

    Rows rows() const { return announced_; }  ///< the last ones that fit
    void setRows(const Rows& rows);           ///< announces nothing
    bool isSound() const { return sound_; }   ///< do all cells fit?
    void setNames(const QString& name, const QString& help);
    QTableWidget* table() const { return table_; }

    void addRow();     ///< a copy of the current one, below it
    void removeRow();  ///< the selected ones
    void paste();

signals:
    void rowsChanged();  ///< by the user

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// What the table's column shows.
    const FieldInfo& column(int index) const { return info_.columns[shown_[static_cast<std::size_t>(index)]]; }
    void setCell(int row, int column, const QString& text);
    void insertRow(int row, const Row& cells);
    void fill();  ///< shows announced_
    void check();
    std::optional<Value> understand(int row, int column, QString& problem) const;
    void retranslate();

    FieldInfo info_;
    std::vector<std::size_t> shown_;  ///< columns in the table; folded ones go with their row unseen
    QTableWidget* table_;
    QToolButton* add_;
    QToolButton* remove_;
    QToolButton* paste_;
    Rows announced_;
    bool sound_ = true;
};

}  // namespace lathelier
