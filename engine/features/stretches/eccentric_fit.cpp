#include "engine/features/stretches/eccentric_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t arcSectors = 72;  ///< of the circle about the own axis

struct OwnCircle {
    Vector2d centre_mm{0, 0};
    double radius_mm = 0;

    double off_mm(const Vector2d& p) const { return (p - centre_mm).norm() - radius_mm; }
    Vector3d slopesAt(const Vector2d& p) const
    {
        const Vector2d out = (p - centre_mm).normalized();
        return {out.x(), out.y(), 1};
    }
};

OwnCircle algebraicCircle(const std::vector<Vector2d>& places)
{
    Matrix3d normal = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const Vector2d& p : places) {
        const Vector3d row(2 * p.x(), 2 * p.y(), 1);
        normal += row * row.transpose();
        right += row * p.squaredNorm();
    }
    const Vector3d found = normal.ldlt().solve(right);
    return {found.head<2>(), std::sqrt(std::max(0.0, found[2] + found.head<2>().squaredNorm()))};
}

OwnCircle robustCircle(const std::vector<Vector2d>& places, double sigma_mm)
{
    OwnCircle circle = algebraicCircle(places);
    std::vector<double> offs(places.size());
    for (int round = 0; round < stretchProof.rounds; ++round) {
        for (std::size_t i = 0; i < places.size(); ++i) offs[i] = std::abs(circle.off_mm(places[i]));
        const double scale = stretchProof.tukey_sigmas * std::max(sigma_mm / 2, madToSigma * upperMedianInPlace(offs));
        Matrix3d normal = Matrix3d::Zero();
        Vector3d right = Vector3d::Zero();
        for (const Vector2d& p : places) {
            const double off = circle.off_mm(p), weight = tukeyWeight(off / std::max(1e-9, scale));
            const Vector3d row = circle.slopesAt(p);
            normal += weight * row * row.transpose();
            right += weight * off * row;
        }
        const Vector3d step = normal.ldlt().solve(right);
        if (!step.allFinite()) break;
        circle.centre_mm += step.head<2>();
        circle.radius_mm += step[2];
        if (step.norm() < stretchProof.settled_mm) break;
    }
    return circle;
}

/// Points on the circle: their share, rms, part of the circle that they cover, and the cofactors of their fit.
struct OnCircle {
    double share = 0, rms_mm = 0, arc_share = 0;
    Matrix3d cofactor = Matrix3d::Zero();
};

OnCircle pointsOn(const OwnCircle& circle, const std::vector<Vector2d>& places, double limit_mm)
{
    OnCircle on;
    double n = 0, squares = 0;
    Matrix3d normal = Matrix3d::Zero();
    std::vector<char> seen(arcSectors, 0);
    for (const Vector2d& p : places) {
        const double off = circle.off_mm(p);
        if (std::abs(off) > limit_mm) continue;
        n += 1;
        squares += off * off;
        const Vector3d row = circle.slopesAt(p);
        normal += row * row.transpose();
        const double turn = std::atan2(row.y(), row.x()) / turn_rad + 0.5;
        seen[std::min<std::size_t>(seen.size() - 1, static_cast<std::size_t>(turn * arcSectors))] = 1;
    }
    on.share = n / static_cast<double>(places.size());
    on.rms_mm = std::sqrt(squares / std::max(1.0, n));
    on.arc_share = static_cast<double>(std::count(seen.begin(), seen.end(), 1)) / static_cast<double>(seen.size());
    on.cofactor = normal.ldlt().solve(Matrix3d::Identity());
    return on;
}

/// Is the circle of each part along z the same?
bool isSameAlong(const OwnCircle& circle, const StretchPoints& points, const std::vector<Vector2d>& places,
                 double limit_mm)
{
    const auto [low, high] = std::minmax_element(points.z_mm.begin(), points.z_mm.end());
    const double first = *low, length = std::max(1e-9, *high - *low);
    const auto parts = static_cast<double>(stretchProof.z_parts);
    std::vector<Matrix3d> normal(stretchProof.z_parts, Matrix3d::Zero());
    std::vector<Vector3d> right(stretchProof.z_parts, Vector3d::Zero());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double off = circle.off_mm(places[i]);
        if (std::abs(off) > 2 * limit_mm) continue;
        const auto part =
            std::min(stretchProof.z_parts - 1, static_cast<std::size_t>(parts * (points.z_mm[i] - first) / length));
        const Vector3d row = circle.slopesAt(places[i]);
        normal[part] += row * row.transpose();
        right[part] += off * row;
    }
    for (std::size_t part = 0; part < stretchProof.z_parts; ++part) {
        const Vector3d step = normal[part].ldlt().solve(right[part]);
        const Matrix3d cofactor = normal[part].ldlt().solve(Matrix3d::Identity());
        const double u = points.sigma_mm * std::sqrt(stretchProof.dependent_points *
                                                     std::max({cofactor(0, 0), cofactor(1, 1), cofactor(2, 2)}));
        if (!(step.cwiseAbs().maxCoeff() < stretchProof.drift_sigmas * u + stretchProof.drift_mm)) return false;
    }
    return true;
}

}  // namespace

std::optional<FoundShape> eccentricOf(const StretchPoints& points)
{
    std::vector<Vector2d> places;
    places.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) places.push_back(points.across_mm(i));
    const OwnCircle circle = robustCircle(places, points.sigma_mm);
    const double offset = circle.centre_mm.norm();
    if (!(offset >= stretchProof.least_offset_mm) || !(circle.radius_mm > 0)) return std::nullopt;
    const OnCircle on = pointsOn(circle, places, points.onShape_mm());
    if (on.share < stretchProof.least_on_share || on.rms_mm > points.largestRms_mm() ||
        on.arc_share < stretchProof.least_arc_share || !isSameAlong(circle, points, places, points.onShape_mm()))
        return std::nullopt;
    const Vector2d out = circle.centre_mm / offset;
    const double variance = stretchProof.dependent_points * on.rms_mm * on.rms_mm *
                            (out.transpose() * on.cofactor.topLeftCorner<2, 2>() * out)(0, 0);
    const double u =
        std::sqrt(variance + points.axis_sigma_mm * points.axis_sigma_mm + stretchProof.form_mm * stretchProof.form_mm);
    FoundShape found;
    found.shape.kind = MarkKind::Eccentric;
    found.shape.level_mm = circle.radius_mm;
    found.shape.centre_mm = circle.centre_mm;
    found.mark.kind = MarkKind::Eccentric;
    found.mark.diameter_mm = 2 * circle.radius_mm;
    found.mark.offset_mm = offset;
    found.mark.angle_deg = markAngle_deg(std::atan2(out.y(), out.x()) / turn_rad);
    found.mark.uncertainty_mm = 2 * u;
    found.mark.angle_uncertainty_deg = std::atan2(2 * u, offset) * deg_per_rad;
    return found;
}

}  // namespace lathelier::features
