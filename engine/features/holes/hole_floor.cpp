#include "engine/features/holes/hole_floor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/holes/hole_limits.h"

namespace lathelier::features {
namespace {

/// A point inside a hole: from its axis as a share of its radius, depth below the wall, and along its axis.
struct DeepPoint {
    double share = 0, below_mm = 0, along_mm = 0;
};

std::vector<DeepPoint> deepPoints(const MeridianCloud& cloud, const WallRim& rim, double limit_mm)
{
    std::vector<DeepPoint> points;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double along_z = static_cast<double>(cloud.z_mm[i]) - rim.z_mm;
        if (std::abs(along_z) > rim.radius_mm) continue;
        const double turn = turn_rad * static_cast<double>(cloud.turn[i]) - rim.angle_rad,
                     r = static_cast<double>(cloud.r_mm[i]);
        const double along = r * std::cos(turn), from_axis = std::hypot(along_z, r * std::sin(turn)) / rim.radius_mm;
        if (!(along > 0) || from_axis > 1 || rim.wall_mm - r < limit_mm) continue;
        points.push_back({from_axis, rim.wall_mm - r, along});
    }
    return points;
}

/// A line through heights along the axis of the hole over the distance from it.
struct FloorLine {
    double at_axis_mm = 0, slope_mm = 0, rms_mm = 0;
};

FloorLine floorLine(const std::vector<DeepPoint>& points)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const DeepPoint& p : points) {
        n += 1;
        sx += p.share;
        sy += p.along_mm;
        sxx += p.share * p.share;
        sxy += p.share * p.along_mm;
    }
    FloorLine line;
    line.slope_mm = (n * sxy - sx * sy) / std::max(1e-9, n * sxx - sx * sx);
    line.at_axis_mm = (sy - line.slope_mm * sx) / n;
    for (const DeepPoint& p : points) {
        const double off = p.along_mm - line.at_axis_mm - line.slope_mm * p.share;
        line.rms_mm += off * off / n;
    }
    line.rms_mm = std::sqrt(line.rms_mm);
    return line;
}

}  // namespace

HoleFloor floorOf(const MeridianCloud& cloud, const WallRim& rim, double limit_mm)
{
    std::vector<DeepPoint> points = deepPoints(cloud, rim, limit_mm);
    std::erase_if(points, [](const DeepPoint& p) { return p.share > holeLimits.floor_share; });
    HoleFloor floor;
    if (points.size() < holeLimits.least_floor_points) return floor;
    std::vector<double> all, outer;
    for (const DeepPoint& p : points) {
        all.push_back(p.below_mm);
        if (p.share > holeLimits.outer_share) outer.push_back(p.below_mm);
    }
    if (outer.size() < holeLimits.least_floor_points) outer = all;
    const double deepest = lowerQuantileInPlace(all, 0.9), shallow = lowerQuantileInPlace(outer, 0.2);
    floor.is_dent = shallow < std::max(holeLimits.least_depth_mm, holeLimits.least_wall_share * deepest);
    if (floor.is_dent) return floor;
    FloorLine line = floorLine(points);
    if (line.rms_mm > holeLimits.floor_scatter_mm) return floor;
    const bool is_point = line.slope_mm > holeLimits.least_tip_slope * rim.radius_mm;
    double mean = 0;
    for (const DeepPoint& p : points) mean += p.along_mm / static_cast<double>(points.size());
    floor.depth_mm = rim.wall_mm - (is_point ? line.at_axis_mm + line.slope_mm : mean);
    return floor;
}

}  // namespace lathelier::features
