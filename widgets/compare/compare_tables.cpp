#include "widgets/compare/compare_tables.h"

#include <algorithm>
#include <cmath>

#include "engine/registration/compare_report.h"
#include "widgets/core/language.h"

namespace lathelier::compare_panel {

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
    setTable(zonesTable(result));
    const int first = result.parameters.zones.empty() ? 0 : 1;  // behind the name
    horizontalHeaderItem(first + 3)->setToolTip(tr("Expanded uncertainty of the mean (k = 2)"));
    horizontalHeaderItem(first + 4)->setToolTip(tr("Standard deviation of the single points in the zone"));
    for (int row = 0; row < rowCount(); ++row) {
        QTableWidgetItem& mean = *item(row, first + 2);
        if (zones_[static_cast<std::size_t>(row)].mean_mm > 0) mean.setText("+" + mean.text());
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
