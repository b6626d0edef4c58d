// An editable table of rows: the segments of a shaft, the rods of a measurement.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "engine/core/fields.h"

class QTableWidget;
class QToolButton;

namespace lathelier {

/// Edits Rows by the columns of their description. Rows are added, removed, and pasted from a spreadsheet
/// (tab-separated cells, from the current cell on). An invalid cell is marked with a symbol and a tooltip; the rows are
/// reported once all cells are valid.
class RowsEdit : public QWidget {
    Q_OBJECT
public:
    explicit RowsEdit(const FieldInfo& info, QWidget* parent = nullptr);

    Rows rows() const { return announced_; }  ///< last valid rows
    void setRows(const Rows& rows);           ///< sets the rows without a signal
    bool isSound() const { return sound_; }   ///< true: all cells are valid
    void setNames(const QString& name, const QString& help);
    QTableWidget* table() const { return table_; }

    void addRow();     ///< a copy of the current one, below it
    void removeRow();  ///< removes the selected rows
    void paste();

signals:
    void rowsChanged();  ///< emitted on a change by the user

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// Field of the table's column.
    const FieldInfo& column(int index) const { return info_.columns[shown_[static_cast<std::size_t>(index)]]; }
    void setCell(int row, int column, const QString& text);
    void insertRow(int row, const Row& cells);
    void fill();  ///< shows the last reported rows
    void check();
    std::optional<Value> understand(int row, int column, QString& problem) const;
    void retranslate();

    FieldInfo info_;
    std::vector<std::size_t> shown_;  ///< columns in the table; hidden ones are kept with their row
    QTableWidget* table_;
    QToolButton* add_;
    QToolButton* remove_;
    QToolButton* paste_;
    Rows announced_;
    bool sound_ = true;
};

}  // namespace lathelier
