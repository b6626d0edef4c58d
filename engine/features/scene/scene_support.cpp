#include "engine/features/scene/scene_support.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/features/scene/scene_limits.h"
#include "engine/features/scene/scene_shapes.h"

namespace lathelier::features {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b, const Vector2d& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Area of the convex hull (Andrew's monotone chain).
double hullArea_mm2(std::vector<Vector2d> points)
{
    if (points.size() < 3) return 0;
    std::sort(points.begin(), points.end(),
              [](const Vector2d& a, const Vector2d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Vector2d> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t base = hull.size();
        for (const Vector2d& point : points) {
            while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    double twice = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vector2d &a = hull[i], &b = hull[(i + 1) % hull.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2;
}

/// Area in the plane of the largest group of the points.
double largestGroup_mm2(const std::vector<Vector3d>& points, double gap_mm, const Vector3d& normal)
{
    const auto groups = groupsOf(points, gap_mm, sceneLimits.least_area_points);
    if (groups.empty()) return 0;
    const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<Vector2d> flat;
    for (const std::uint32_t i : groups.front()) flat.emplace_back(u.dot(points[i]), v.dot(points[i]));
    return hullArea_mm2(std::move(flat));
}

}  // namespace

std::optional<SupportPlane> findSupport(const std::vector<Vector3d>& points, double spacing_mm)
{
    constexpr double tolerance_mm = sceneLimits.plane_tolerance_mm;
    std::optional<ScenePlane> plane = largestPlane(points, tolerance_mm);
    if (!plane ||
        static_cast<double>(plane->inliers.size()) < sceneLimits.least_plane_share * static_cast<double>(points.size()))
        return std::nullopt;
    std::vector<Vector3d> on, off;
    std::vector<double> heights;
    double above = 0, below = 0;
    for (const Vector3d& point : points) {
        const double height = plane->height_mm(point);
        (std::abs(height) <= tolerance_mm ? on : off).push_back(point);
        if (std::abs(height) <= tolerance_mm) heights.push_back(std::abs(height));
        above += height > 2 * tolerance_mm;
        below += height < -2 * tolerance_mm;
    }
    if (std::min(above, below) > sceneLimits.largest_share_behind * (above + below)) return std::nullopt;
    const double gap_mm = sceneLimits.group_gap_cubes * spacing_mm;
    const double own = largestGroup_mm2(on, gap_mm, plane->normal);
    if (!(own > sceneLimits.least_area_ratio * largestGroup_mm2(off, gap_mm, plane->normal))) return std::nullopt;
    SupportPlane support;
    const double sense = above >= below ? 1 : -1;
    support.normal = sense * plane->normal;
    support.distance_mm = sense * plane->distance_mm;
    support.sigma_mm = madToSigma * median(std::move(heights));
    support.band_mm = std::clamp(sceneLimits.support_band_sigmas * support.sigma_mm, sceneLimits.least_support_band_mm,
                                 2 * tolerance_mm);
    return support;
}

bool endOnSupport(const SupportPlane& support, const registration::RevolutionFit& fit, Outline& outline,
                  const Progress& progress)
{
    const Vector3d axis = fit.axis_T_scan.linear().transpose().col(2);
    const double cosine = support.normal.dot(axis);
    if (std::abs(cosine) < std::cos(sceneLimits.largest_lean_deg * std::numbers::pi / 180)) return false;
    // Where the axis meets the plane.
    const Vector3d origin = fit.axis_T_scan.inverse().translation();
    const double z = (support.distance_mm - support.normal.dot(origin)) / cosine;
    Model& model = outline.model;
    const bool first = cosine > 0;  // the part stands on its end with the smaller z
    Plane& plane = first ? model.planes.front() : model.planes.back();
    Run& run = first ? model.runs.front() : model.runs.back();
    const double missing = first ? plane.z_mm - z : z - plane.z_mm;
    if (missing < -sceneLimits.end_reach_mm || missing > 2 * support.band_mm + sceneLimits.end_reach_mm) return false;
    if (run.elements[first ? 0 : run.elements.size() - 1].arc) return false;  // it may end before the plane
    plane.z_mm = plane.seen_mm = z;
    plane.sigma_mm = std::max(sceneLimits.least_end_sigma_mm, support.sigma_mm / sceneLimits.end_sigma_ratio);
    plane.data_end = false;
    resolve(model, run);
    outline.fit = fitAll(model, sceneLimits.end_fit_iterations, progress);
    outline.face_seen[first ? 0 : 1] = true;
    return true;
}

}  // namespace lathelier::features
