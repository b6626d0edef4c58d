#include "engine/features/scene/surroundings/point_cubes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lathelier::features {
namespace {

constexpr int bitsPerAxis = 21;
constexpr std::int64_t lastCell = (std::int64_t{1} << bitsPerAxis) - 1;

std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z)
{
    return static_cast<std::uint64_t>(x) << (2 * bitsPerAxis) | static_cast<std::uint64_t>(y) << bitsPerAxis |
           static_cast<std::uint64_t>(z);
}

std::int64_t cellOf(double offset_mm, double edge_mm)
{
    return static_cast<std::int64_t>(std::clamp(offset_mm / edge_mm, 0.0, static_cast<double>(lastCell)));
}

}  // namespace

PointCubes::PointCubes(const std::vector<Eigen::Vector3d>& points, double edge_mm)
{
    start_.assign(1, 0);
    if (points.empty()) return;
    Eigen::Vector3d low = points.front();
    for (const Eigen::Vector3d& point : points) low = low.cwiseMin(point);
    std::vector<Cell> cell_of(points.size());
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d offset = points[i] - low;
        cell_of[i] = {cellOf(offset.x(), edge_mm), cellOf(offset.y(), edge_mm), cellOf(offset.z(), edge_mm)};
        keys[i] = {keyOf(cell_of[i].x, cell_of[i].y, cell_of[i].z), static_cast<std::uint32_t>(i)};
    }
    std::sort(keys.begin(), keys.end());
    // Runs of one key are cubes; their first points give the order of the cubes.
    std::vector<std::size_t> runs;
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (k == 0 || keys[k].first != keys[k - 1].first) runs.push_back(k);
    std::vector<std::size_t> by_first(runs.size());
    std::iota(by_first.begin(), by_first.end(), std::size_t{0});
    std::sort(by_first.begin(), by_first.end(),
              [&](std::size_t a, std::size_t b) { return keys[runs[a]].second < keys[runs[b]].second; });
    sorted_.resize(runs.size());
    for (std::size_t cube = 0; cube < runs.size(); ++cube) {
        const std::size_t run = by_first[cube], to = run + 1 < runs.size() ? runs[run + 1] : keys.size();
        for (std::size_t k = runs[run]; k < to; ++k) order_.push_back(keys[k].second);
        start_.push_back(order_.size());
        cells_.push_back(cell_of[keys[runs[run]].second]);
        sorted_[run] = {keys[runs[run]].first, static_cast<std::uint32_t>(cube)};
    }
}

std::ptrdiff_t PointCubes::find(std::int64_t x, std::int64_t y, std::int64_t z) const
{
    if (std::min({x, y, z}) < 0 || std::max({x, y, z}) > lastCell) return -1;
    const std::uint64_t key = keyOf(x, y, z);
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(key, std::uint32_t{0}));
    return found != sorted_.end() && found->first == key ? static_cast<std::ptrdiff_t>(found->second) : -1;
}

std::vector<std::size_t> PointCubes::around(const std::vector<std::size_t>& cubes, int rings) const
{
    std::vector<std::size_t> all;
    for (const std::size_t cube : cubes)
        for (int dx = -rings; dx <= rings; ++dx)
            for (int dy = -rings; dy <= rings; ++dy)
                for (int dz = -rings; dz <= rings; ++dz)
                    if (const auto at = find(cells_[cube].x + dx, cells_[cube].y + dy, cells_[cube].z + dz); at >= 0)
                        all.push_back(static_cast<std::size_t>(at));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<std::vector<std::size_t>> PointCubes::groups(const std::function<bool(std::size_t)>& is_used) const
{
    std::vector<char> open(size(), 0);
    for (std::size_t cube = 0; cube < size(); ++cube) open[cube] = is_used(cube) ? 1 : 0;
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t seed = 0; seed < size(); ++seed) {
        if (!open[seed]) continue;
        open[seed] = 0;
        std::vector<std::size_t>& group = groups.emplace_back(1, seed);
        for (std::size_t next = 0; next < group.size(); ++next)
            for (const std::size_t beside : around({group[next]}, 1))
                if (open[beside]) {
                    open[beside] = 0;
                    group.push_back(beside);
                }
        std::sort(group.begin(), group.end());
    }
    return groups;
}

}  // namespace lathelier::features
