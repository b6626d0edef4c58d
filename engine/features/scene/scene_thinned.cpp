#include "engine/features/scene/scene_thinned.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/features/scene/scene_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

constexpr int keyBitsPerAxis = 21;  // of a key for each axis

struct Mix {
    std::size_t operator()(std::uint64_t key) const
    {
        key = (key ^ (key >> 31)) * 0x9E3779B97F4A7C15ULL;
        return static_cast<std::size_t>(key ^ (key >> 29));
    }
};

std::uint64_t keyOf(double offset_mm, double edge_mm)
{
    constexpr double last = (1 << keyBitsPerAxis) - 1;
    return static_cast<std::uint64_t>(std::clamp(offset_mm / edge_mm, 0.0, last));
}

}  // namespace

Thinned thinned(const std::vector<Vector3d>& points, double edge_mm, const Progress& progress)
{
    Thinned result;
    result.edge_mm = edge_mm;
    if (points.empty()) return result;
    Vector3d low = points.front();
    for (const Vector3d& point : points) low = low.cwiseMin(point);
    std::vector<std::uint64_t> keys(points.size());
    parallelFor(points.size(), 32768, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vector3d offset = points[i] - low;
            keys[i] = keyOf(offset.x(), edge_mm) << (2 * keyBitsPerAxis) |
                      keyOf(offset.y(), edge_mm) << keyBitsPerAxis | keyOf(offset.z(), edge_mm);
        }
    });
    std::unordered_map<std::uint64_t, std::uint32_t, Mix> cubes;
    result.of_point.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [cube, is_new] = cubes.try_emplace(keys[i], static_cast<std::uint32_t>(result.points.size()));
        if (is_new) result.points.push_back(points[i]);
        result.of_point[i] = cube->second;
    }
    progress.check();
    return result;
}

std::vector<Vector3d> everyNth(const std::vector<Vector3d>& points, std::size_t most)
{
    if (points.size() <= most) return points;
    std::vector<Vector3d> some;
    some.reserve(most);
    for (std::size_t i = 0; i < most; ++i) some.push_back(points[i * points.size() / most]);
    return some;
}

double usualExtent_mm(const std::vector<Vector3d>& points)
{
    const std::vector<Vector3d> some = everyNth(points, sceneLimits.extent_sample);
    double squares = 0;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        values.reserve(some.size());
        for (const Vector3d& point : some) values.push_back(point[axis]);
        const double low = quantileInPlace(values, sceneLimits.extent_low_share),
                     high = quantileInPlace(values, sceneLimits.extent_high_share);
        squares += (high - low) * (high - low);
    }
    return std::sqrt(squares);
}

}  // namespace lathelier::features
