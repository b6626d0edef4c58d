#include "widgets/turning/operations_table.h"

#include <QSignalBlocker>

namespace lathelier::turning_panel {

OperationsTable::OperationsTable(QWidget* parent) : CopyTable(parent)
{
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row, int, int before, int) {
        if (row < 0 || row == before || row >= static_cast<int>(lines_.size())) return;
        const Line& line = lines_[static_cast<std::size_t>(row)];
        if (line.first_line > 0) emit lineChosen(line.first_line);
    });
    connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
        const auto row = static_cast<std::size_t>(item->row());
        if (item->column() != 0 || row >= lines_.size()) return;
        const bool on = item->checkState() == Qt::Checked;
        const Line line = lines_[row];  // the table may be filled anew meanwhile
        if (on != line.is_planned) emit switched(line.which, on);
    });
}

void OperationsTable::setOutcome(const cam::TurningOutcome& outcome, std::size_t setup)
{
    const QSignalBlocker quiet(this);
    setTable(operationTable(outcome, setup));
    lines_.clear();
    for (const cam::ListedOperation& operation : listedOperations(outcome, setup)) {
        Line& line = lines_.emplace_back();
        line.which = operation.which;
        line.is_planned = operation.planned.has_value();
        if (operation.planned) line.first_line = outcome.plan->setups[setup].operations[*operation.planned].first_line;
        QTableWidgetItem* cell = item(static_cast<int>(lines_.size()) - 1, 0);
        if (!cell) continue;
        cell->setFlags(cell->flags() | Qt::ItemIsUserCheckable);
        cell->setCheckState(operation.planned ? Qt::Checked : Qt::Unchecked);
    }
    fitCells();
}

}  // namespace lathelier::turning_panel
