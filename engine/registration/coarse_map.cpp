#include "engine/registration/coarse_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::registration {
namespace {

constexpr double stepsPer_mm = 1e4;

/// The largest number of columns up to coarseColumns whose width is a whole number of the map's columns.
int columnsOf(int angle_count)
{
    for (int columns = std::min(coarseColumns, angle_count); columns > 1; --columns)
        if (angle_count % columns == 0) return columns;
    return 1;
}

}  // namespace

const std::vector<QuantityOf<CoarseMap>>& quantitiesOf(const CoarseMap*)
{
    using M = CoarseMap;
    static const auto all =
        describedBy<M>(quantity<M>("z_start_mm", &M::z_start_mm), quantity<M>("z_step_mm", &M::z_step_mm),
                       quantity<M>("z_count", &M::z_count), quantity<M>("angle_count", &M::angle_count),
                       quantity<M>("mean_mm", &M::mean_mm));
    return all;
}

CoarseMap coarseOf(const UnrolledMap& map)
{
    CoarseMap coarse;
    if (map.z_count < 1 || map.angle_count < 1) return coarse;
    const int high = (map.z_count + coarseRows - 1) / coarseRows;
    coarse.angle_count = columnsOf(map.angle_count);
    coarse.z_count = (map.z_count + high - 1) / high;
    const int wide = map.angle_count / coarse.angle_count;
    coarse.z_start_mm = map.z_start_mm;
    coarse.z_step_mm = map.z_step_mm * high;
    const auto cells = static_cast<std::size_t>(coarse.z_count) * static_cast<std::size_t>(coarse.angle_count);
    std::vector<double> sums(cells, 0);
    std::vector<int> counts(cells, 0);
    for (int row = 0; row < map.z_count; ++row)
        for (int column = 0; column < map.angle_count; ++column) {
            const auto from = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.angle_count) +
                              static_cast<std::size_t>(column);
            const double mean = static_cast<double>(map.mean_mm[from]);
            if (std::isnan(mean)) continue;
            const auto to = static_cast<std::size_t>(row / high) * static_cast<std::size_t>(coarse.angle_count) +
                            static_cast<std::size_t>(column / wide);
            sums[to] += mean;
            ++counts[to];
        }
    coarse.mean_mm.resize(cells, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t cell = 0; cell < cells; ++cell)
        if (counts[cell] > 0)
            coarse.mean_mm[cell] =
                static_cast<double>(std::lround(stepsPer_mm * sums[cell] / counts[cell])) / stepsPer_mm;
    return coarse;
}

}  // namespace lathelier::registration
