#include "widgets/compare/compare_tables.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "engine/registration/compare_report.h"
#include "widgets/core/language.h"

namespace lathelier::compare_panel {
namespace {

QString signedNumber(double value, int decimals)
{
    return (value > 0 ? "+" : "") + screenNumber(value, decimals);
}

}  // namespace

StatisticsTable::StatisticsTable(QWidget* parent) : CopyTable(parent)
{
    setObjectName("statistics");
    setAccessibleName(tr("Statistics"));
}

void StatisticsTable::setPicture(const ComparePicture& picture)
{
    setQuantities(compareReport(*picture.result, picture.inputs, screenLanguage()));
}

ZoneTable::ZoneTable(QWidget* parent) : CopyTable(parent)
{
    setObjectName("zones");
    setColumnCount(8);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setAccessibleName(tr("Zones along the axis"));
    connect(this, &QTableWidget::cellClicked, this, [this](int row, int) {
        const registration::Zone& zone = zones_[static_cast<std::size_t>(row)];
        emit zonePicked((zone.z_start_mm + zone.z_end_mm) / 2);
    });
}

void ZoneTable::setResult(const registration::CompareResult& result)
{
    zones_ = result.zones;
    setHorizontalHeaderLabels({tr("From (mm)"), tr("To (mm)"), tr("Mean (mm)"), tr("U (mm)"), tr("Scatter (mm)"),
                               tr("Points"), tr("Verdict"), tr("Name")});
    horizontalHeaderItem(3)->setToolTip(tr("Expanded uncertainty of the mean (k = 2)"));
    horizontalHeaderItem(4)->setToolTip(tr("Standard deviation of the single points in the zone"));
    const bool named = std::any_of(zones_.begin(), zones_.end(), [](const auto& zone) { return !zone.name.empty(); });
    setColumnHidden(7, !named);
    setRowCount(static_cast<int>(zones_.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const registration::Zone& zone = zones_[static_cast<std::size_t>(row)];
        setItem(row, 0, tableCell(screenNumber(zone.z_start_mm, 1), true));
        setItem(row, 1, tableCell(screenNumber(zone.z_end_mm, 1), true));
        setItem(row, 2, tableCell(signedNumber(zone.mean_mm, 4), true));
        setItem(row, 3, tableCell(screenNumber(zone.uncertainty_mm, 4), true));
        setItem(row, 4, tableCell(screenNumber(zone.std_mm, 4), true));
        setItem(row, 5, tableCell(QLocale().toString(static_cast<qlonglong>(zone.points)), true));
        setItem(row, 6, tableCell(zone.verdict ? screenText(shortName(*zone.verdict)) : QStringLiteral("–"), false));
        setItem(row, 7, tableCell(QString::fromStdString(zone.name), false));
    }
    fitCells();
}

void ZoneTable::markZ(std::optional<double> z_mm)
{
    clearSelection();
    if (!z_mm) return;
    // Zones keep a little away from edges: a place between two of them belongs to the nearer one.
    const auto away = [&](const registration::Zone& zone) {
        return std::max({zone.z_start_mm - *z_mm, *z_mm - zone.z_end_mm, 0.0});
    };
    const auto nearest =
        std::min_element(zones_.begin(), zones_.end(),
                         [&](const registration::Zone& a, const registration::Zone& b) { return away(a) < away(b); });
    if (nearest == zones_.end()) return;
    const int row = static_cast<int>(nearest - zones_.begin());
    selectRow(row);
    scrollToItem(item(row, 0));
}

}  // namespace lathelier::compare_panel
