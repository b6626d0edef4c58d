#include "engine/features/walls/mesh_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/features/walls/wall_limits.h"
#include "engine/registration/surface/facet_sagitta.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

using Corners = std::array<Vector3d, 3>;

Vector3d flat(const Corners& p, const registration::SurfaceSample& at)
{
    return p[0] + at.s * (p[1] - p[0]) + at.t * (p[2] - p[0]);
}

/// Interpolated in (r, angle, z).
Vector3d rounded(const Corners& p, const registration::SurfaceSample& at, double usual_sagitta_mm)
{
    const Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    if (!(normal.head<2>().norm() > meshLimits.face_normal_share * normal.norm())) return flat(p, at);
    std::array<double, 3> radius{}, turn{};
    for (std::size_t k = 0; k < 3; ++k) {
        radius[k] = p[k].head<2>().norm();
        turn[k] = std::remainder(std::atan2(p[k].y(), p[k].x()) - (k > 0 ? turn[0] : 0), 2 * std::numbers::pi) +
                  (k > 0 ? turn[0] : 0);
    }
    const auto [least, most] = std::minmax_element(turn.begin(), turn.end());
    const double span = *most - *least, largest = *std::max_element(radius.begin(), radius.end());
    if (!(*std::min_element(radius.begin(), radius.end()) > meshLimits.least_radius_share * largest))
        return flat(p, at);
    if (span > meshLimits.largest_span_rad) return flat(p, at);
    if (largest * (1 - std::cos(span / 2)) > meshLimits.flat_sagitta_ratio * usual_sagitta_mm) return flat(p, at);
    const double r = radius[0] + at.s * (radius[1] - radius[0]) + at.t * (radius[2] - radius[0]);
    const double angle = turn[0] + at.s * (turn[1] - turn[0]) + at.t * (turn[2] - turn[0]);
    return {r * std::cos(angle), r * std::sin(angle), flat(p, at).z()};
}

Corners cornersOf(const Scan& mesh, std::uint32_t triangle)
{
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]};
}

}  // namespace

std::vector<Vector3d> flatPoints(const Scan& mesh, const std::vector<registration::SurfaceSample>& samples,
                                 const Progress& progress)
{
    std::vector<Vector3d> points(samples.size());
    parallelFor(samples.size(), 16384, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) points[i] = flat(cornersOf(mesh, samples[i].triangle), samples[i]);
    });
    return points;
}

RoundedPoints roundedPoints(const Scan& mesh, const std::vector<registration::SurfaceSample>& samples,
                            const registration::RevolutionFit& fit, const Progress& progress)
{
    RoundedPoints result;
    result.sagitta_mm = registration::facetSagitta_mm(mesh, fit.axis_T_scan, progress);
    if (!(result.sagitta_mm > meshLimits.least_sagitta_mm)) return result;
    const Eigen::Isometry3d scan_T_axis = fit.axis_T_scan.inverse();
    result.points.resize(samples.size());
    parallelFor(samples.size(), 8192, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Corners corners = cornersOf(mesh, samples[i].triangle);
            for (Vector3d& corner : corners) corner = fit.axis_T_scan * corner;
            result.points[i] = scan_T_axis * rounded(corners, samples[i], result.sagitta_mm);
        }
    });
    return result;
}

}  // namespace lathelier::features
