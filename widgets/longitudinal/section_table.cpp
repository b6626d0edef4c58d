#include "widgets/longitudinal/section_table.h"

#include <cmath>

#include "widgets/core/language.h"

namespace lathelier::longitudinal_panel {

SectionTable::SectionTable(QWidget* parent) : CopyTable(parent)
{
    setObjectName("sections");
    setColumnCount(10);
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
    const form::ReferenceCircle circle = result.parameters.form.circle;
    setHorizontalHeaderLabels(
        {tr("Section"), tr("z (mm)"),
         QString("RONt(%1) (µm)").arg(QString::fromLatin1(name(circle).data(), static_cast<int>(name(circle).size()))),
         tr("Verdict"), tr("Diameter (mm)"), tr("Centre x (µm)"), tr("Centre y (µm)"), tr("Run-out (µm)"),
         tr("Two-point (µm)"), tr("Turns")});
    horizontalHeaderItem(7)->setToolTip(tr("Largest minus smallest radius about the spindle axis: the paper's value"));
    horizontalHeaderItem(8)->setToolTip(
        tr("Two-point range: largest minus smallest distance of opposite points; half of it: GOST"));
    horizontalHeaderItem(4)->setToolTip(tr("Referenced to the nominal diameter"));
    numbers_.clear();
    setRowCount(static_cast<int>(result.sections.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const trajectory::TrajectorySection& section = result.sections[static_cast<std::size_t>(row)];
        const form::FittedCircle& place = section.roundness.circles.LSCI;
        numbers_.push_back(section.section);
        const auto number = [&](int column, double value, int decimals) {
            setItem(row, column,
                    tableCell(std::isfinite(value) ? screenNumber(value, decimals) : QStringLiteral("–"), true));
        };
        setItem(row, 0, tableCell(QString::number(section.section), true));
        number(1, section.z_mm, 2);
        number(2, headlineDeviation_um(section.roundness), 2);
        const QString verdict =
            section.roundness.verdict ? screenText(shortName(*section.roundness.verdict)) : QStringLiteral("–");
        setItem(row, 3, tableCell(verdict, false));
        number(4, 2 * place.radius_mm, 4);
        number(5, place.centre_mm.x() * 1000, 2);
        number(6, place.centre_mm.y() * 1000, 2);
        number(7, section.run_out_um, 2);
        number(8, section.roundness.two_point.range_um, 2);
        setItem(
            row, 9,
            tableCell(section.revolutions_used > 0 ? QString::number(section.revolutions_used) : QStringLiteral("–"),
                      true));
    }
    fitCells();
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
