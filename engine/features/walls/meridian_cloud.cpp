#include "engine/features/walls/meridian_cloud.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/features/walls/wall_limits.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::features {
namespace {

/// Sets the extent of the data and their density: steps at the ends with few points hold stray ones.
void measureExtent(MeridianCloud& cloud)
{
    const double step_mm = wallLimits.density_step_mm;
    const auto [low, high] = std::minmax_element(cloud.z_mm.begin(), cloud.z_mm.end());
    const double first = static_cast<double>(*low), last = static_cast<double>(*high);
    const auto count = static_cast<std::size_t>((last - first) / step_mm) + 1;
    if (count > wallLimits.most_density_steps) {
        cloud.z_first_mm = first;
        cloud.z_last_mm = last;
        return;
    }
    std::vector<float> counts(count, 0);
    for (const float z : cloud.z_mm) ++counts[static_cast<std::size_t>((static_cast<double>(z) - first) / step_mm)];
    std::vector<float> there;
    for (const float c : counts)
        if (c > 0) there.push_back(c);
    const double usual = static_cast<double>(upperMedianInPlace(there));
    cloud.points_per_mm = usual / step_mm;
    const double sparse = wallLimits.sparse_end_share * usual;
    std::size_t from = 0, to = count;
    while (from + 1 < to && static_cast<double>(counts[from]) < sparse) ++from;
    while (to > from + 1 && static_cast<double>(counts[to - 1]) < sparse) --to;
    cloud.z_first_mm = first + step_mm * static_cast<double>(from) - step_mm;
    cloud.z_last_mm = first + step_mm * static_cast<double>(to) + step_mm;
}

}  // namespace

MeridianCloud meridianCloud(const std::vector<Eigen::Vector3d>& points, const Progress& progress)
{
    MeridianCloud cloud;
    const std::size_t n = points.size();
    cloud.z_mm.resize(n);
    cloud.r_mm.resize(n);
    cloud.turn.resize(n);
    parallelFor(n, 32768, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d& p = points[i];
            cloud.z_mm[i] = static_cast<float>(p.z());
            cloud.r_mm[i] = static_cast<float>(std::sqrt(p.x() * p.x() + p.y() * p.y()));
            const double turn = registration::quickTurn(p.y(), p.x());
            cloud.turn[i] = static_cast<float>(turn < 0 ? turn + 1 : turn);
        }
    });
    if (n > 0) measureExtent(cloud);
    return cloud;
}

}  // namespace lathelier::features
