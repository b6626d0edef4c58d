#include "widgets/longitudinal/section_table.h"

#include "engine/trajectory/trajectory_report.h"

namespace lathelier::longitudinal_panel {

SectionTable::SectionTable(QWidget* parent) : CopyTable(parent)
{
    setObjectName("sections");
    setSelectionMode(QAbstractItemView::SingleSelection);
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row, int, int before, int) {
        if (row >= 0 && row != before && row < static_cast<int>(numbers_.size()))
            emit sectionPicked(numbers_[static_cast<std::size_t>(row)]);
    });
}

void SectionTable::setResult(const trajectory::TrajectoryResult& result)
{
    const QSignalBlocker quiet(this);
    setAccessibleName(tr("All sections against the tolerance"));
    setTable(sectionsTable(result));
    horizontalHeaderItem(4)->setToolTip(tr("Referenced to the nominal diameter"));
    horizontalHeaderItem(7)->setToolTip(tr("Largest minus smallest radius about the spindle axis: the paper's value"));
    horizontalHeaderItem(8)->setToolTip(
        tr("Two-point range: largest minus smallest distance of opposite points; half of it: GOST"));
    numbers_.clear();
    for (const trajectory::TrajectorySection& section : result.sections) numbers_.push_back(section.section);
}

void SectionTable::markSection(std::size_t index)
{
    const QSignalBlocker quiet(this);
    const int row = static_cast<int>(index);
    if (row >= rowCount()) return;
    selectRow(row);
    scrollToItem(item(row, 0));
}

}  // namespace lathelier::longitudinal_panel
