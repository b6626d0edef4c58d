#include "engine/features/structure/map_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/statistics.h"
#include "engine/features/structure/unexplained.h"

namespace lathelier::features {
namespace {

/// Means of the cells about the median of their ring; NaN where too few points are.
struct CellMeans {
    std::vector<float> mean_mm;
    double scatter = 1;  ///< robust standard deviation of means over their noise; 1 for white noise
};

CellMeans cellMeans(const ResidualMap& map)
{
    CellMeans means;
    means.mean_mm.assign(map.cells.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<float> ring, ratios;
    for (std::size_t row = 0; row < map.rows; ++row) {
        ring.clear();
        for (std::size_t s = 0; s < mapSectors; ++s) {
            const MapCell& cell = map.at(row, s);
            if (cell.on < structureThresholds.least_points) continue;
            ring.push_back(means.mean_mm[row * mapSectors + s] = cell.sum_mm / static_cast<float>(cell.on));
        }
        const float middle = upperMedianInPlace(ring);
        for (std::size_t s = 0; s < mapSectors; ++s) {
            float& mean = means.mean_mm[row * mapSectors + s];
            if (std::isnan(mean)) continue;
            mean -= middle;
            const double noise_mm = std::max(map.noise_mm(map.at(row, s)), 1e-9);
            ratios.push_back(static_cast<float>(std::abs(static_cast<double>(mean)) / noise_mm));
        }
    }
    if (!ratios.empty()) means.scatter = std::max(1.0, madToSigma * static_cast<double>(upperMedianInPlace(ratios)));
    return means;
}

}  // namespace

std::vector<std::uint8_t> offCells(const ResidualMap& map, double form_mm)
{
    const CellMeans means = cellMeans(map);
    std::vector<std::uint8_t> off(map.cells.size(), 0);
    for (std::size_t c = 0; c < off.size(); ++c) {
        const MapCell& cell = map.cells[c];
        const bool is_far = cell.far >= structureThresholds.least_far && cell.far > cell.on;
        const double mean = std::abs(static_cast<double>(means.mean_mm[c]));
        const double noise = means.scatter * map.noise_mm(cell);
        off[c] = is_far || (mean > form_mm && mean > structureThresholds.sigmas * noise) ? 1 : 0;  // false for NaN
    }
    return off;
}

std::vector<std::uint8_t> emptyCells(const ResidualMap& map)
{
    std::vector<std::uint8_t> empty(map.cells.size(), 0);
    std::vector<float> window(mapSectors), sorted;
    for (std::size_t row = 0; row < map.rows; ++row) {
        const auto points = [&](std::size_t s) {
            const MapCell& cell = map.at(row, s % mapSectors);
            return static_cast<float>(cell.on + cell.far);
        };
        for (std::size_t s = 0; s < mapSectors; ++s) window[s] = points(s + mapSectors - 1) + points(s) + points(s + 1);
        sorted = window;
        const float usual = upperMedianInPlace(sorted);
        if (usual < structureThresholds.least_usual) continue;
        for (std::size_t s = 0; s < mapSectors; ++s)
            empty[row * mapSectors + s] = window[s] <= structureThresholds.empty_share * usual ? 1 : 0;
    }
    return empty;
}

}  // namespace lathelier::features
