#include "engine/features/scene/surroundings/plane_shares.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/features/scene/surroundings/surroundings_limits.h"

namespace lathelier::features {
namespace {

/// Largest number of values in an interval of this width, and where that begins.
struct Crowd {
    std::size_t count = 0;
    double from = 0;
};

Crowd densestSlab(const std::vector<double>& values, double width, std::vector<std::size_t>& bins)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double step = width / 2;  // an interval is two bins
    bins.assign(static_cast<std::size_t>(std::min((*high - *low) / step, surroundingsLimits.most_plane_bins)) + 2, 0);
    for (const double value : values)
        ++bins[static_cast<std::size_t>(std::min((value - *low) / step, surroundingsLimits.most_plane_bins))];
    Crowd best;
    for (std::size_t b = 0; b + 1 < bins.size(); ++b)
        if (bins[b] + bins[b + 1] > best.count) best = {bins[b] + bins[b + 1], *low + step * static_cast<double>(b)};
    return best;
}

}  // namespace

double planesShare(const std::vector<Eigen::Vector3d>& on_axis, double least_share, double sigma_mm)
{
    std::vector<Eigen::Vector3d> left;
    const std::size_t count = std::min(on_axis.size(), surroundingsLimits.most_plane_points);
    for (std::size_t i = 0; i < count; ++i) left.push_back(on_axis[i * on_axis.size() / count]);
    const double slab = std::max(surroundingsLimits.least_slab_mm, 6 * sigma_mm);
    std::vector<double> heights;
    std::vector<std::size_t> bins;
    const auto heightsAlong = [&](const Eigen::Vector3d& normal) {
        heights.clear();
        for (const Eigen::Vector3d& p : left) heights.push_back(normal.dot(p));
    };
    double in_planes = 0;
    for (int plane = 0; plane < surroundingsLimits.most_planes && !left.empty(); ++plane) {
        Crowd best;
        Eigen::Vector3d best_normal = Eigen::Vector3d::UnitZ();
        for (int k = -1; k < surroundingsLimits.plane_directions; ++k) {
            const double angle = std::numbers::pi * k / surroundingsLimits.plane_directions;
            const Eigen::Vector3d normal =
                k < 0 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
            heightsAlong(normal);
            const Crowd crowd = densestSlab(heights, slab, bins);
            if (crowd.count <= best.count) continue;
            best = crowd;
            best_normal = normal;
        }
        if (static_cast<double>(best.count) < least_share * static_cast<double>(count)) break;
        in_planes += static_cast<double>(best.count);
        std::erase_if(left, [&](const Eigen::Vector3d& p) {
            const double height = best_normal.dot(p);
            return height >= best.from && height <= best.from + slab;
        });
    }
    return count > 0 ? in_planes / static_cast<double>(count) : 0;
}

}  // namespace lathelier::features
