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

void StatisticsTable::setOutcome(const cad::CompareOutcome& outcome)
{
    setQuantities(compareReport(*outcome.result, outcome.sources.inputs, screenLanguage()));
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
    const int first = result.parameters.zones.empty() ? 0 : 1;  // column after the name
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
    // Zones keep a distance from edges: a place between two of them is assigned to the nearer one.
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

SizeTable::SizeTable(QWidget* parent) : CopyTable(parent)
{
    setObjectName("sizes");
    setSelectionMode(QAbstractItemView::SingleSelection);
    connect(this, &QTableWidget::cellClicked, this, [this](int row, int) {
        const Interval& place = places_[static_cast<std::size_t>(row)];
        emit sizePicked((place.from + place.to) / 2);
    });
}

void SizeTable::setSizes(const features::ShaftComparison& sizes)
{
    places_.clear();
    setTable(sizesTable(sizes));
    for (std::size_t i = 0; i < sizes.rows.size(); ++i) {
        places_.push_back(placeOf(sizes, sizes.rows[i]));
        if (!sizes.rows[i].verdict || *sizes.rows[i].verdict == Verdict::Pass) continue;
        for (int column = 0; column < columnCount(); ++column) {
            QFont bold = font();
            bold.setBold(*sizes.rows[i].verdict == Verdict::Fail);
            item(static_cast<int>(i), column)->setFont(bold);
        }
    }
    fitCells();
}

void SizeTable::markZ(std::optional<double> z_mm)
{
    if (z_mm && currentRow() >= 0 && currentRow() < rowCount()) {
        const Interval& now = places_[static_cast<std::size_t>(currentRow())];
        if (*z_mm >= now.from && *z_mm <= now.to) return;  // another size of the same row was selected
    }
    clearSelection();
    if (!z_mm) return;
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (*z_mm >= places_[i].from && *z_mm <= places_[i].to) {
            selectRow(static_cast<int>(i));
            scrollToItem(item(static_cast<int>(i), 0));
            return;
        }
}

}  // namespace lathelier::compare_panel
