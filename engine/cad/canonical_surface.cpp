#include "engine/cad/canonical_surface.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t fewestSpots = 12;
constexpr double sameDirection = 1e-6;  ///< rad; as isAbout() of step_meridian.cpp
constexpr double largestRadius_mm = 1e6;
constexpr double separate = 1e-10;  ///< least second eigenvalue of a unique axis, relative to the largest

Vector3d meanOf(std::span<const SurfaceSpot> spots, Vector3d SurfaceSpot::*member)
{
    Vector3d sum = Vector3d::Zero();
    for (const SurfaceSpot& spot : spots) sum += spot.*member;
    return sum / static_cast<double>(spots.size());
}

/// The direction in which points or normals vary least about `centre`.
Vector3d leastDirection(std::span<const SurfaceSpot> spots, Vector3d SurfaceSpot::*member, const Vector3d& centre)
{
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const SurfaceSpot& spot : spots) scatter += (spot.*member - centre) * (spot.*member - centre).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
}

struct Circle {
    Vector2d centre = Vector2d::Zero();
    double radius = 0;
    double deviation = 0;  ///< largest, of a point
};

/// By Kåsa's equations, exact for points of a circle.
std::optional<Circle> circleThrough(const std::vector<Vector2d>& points)
{
    Vector2d mean = Vector2d::Zero();
    for (const Vector2d& point : points) mean += point / static_cast<double>(points.size());
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 3);
    Eigen::VectorXd squares(static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector2d d = points[i] - mean;
        rows.row(static_cast<Eigen::Index>(i)) << 2 * d.x(), 2 * d.y(), 1;
        squares[static_cast<Eigen::Index>(i)] = d.squaredNorm();
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(rows);
    if (solver.rank() < 3) return std::nullopt;
    const Vector3d solution = solver.solve(squares);
    const double square = solution[2] + solution.head<2>().squaredNorm();
    if (!(square > 0)) return std::nullopt;
    Circle circle{mean + solution.head<2>(), std::sqrt(square), 0};
    for (const Vector2d& point : points)
        circle.deviation = std::max(circle.deviation, std::abs((point - circle.centre).norm() - circle.radius));
    return circle.radius < largestRadius_mm ? std::optional(circle) : std::nullopt;
}

bool fits(double deviation_mm)
{
    return deviation_mm < canonicalTolerance_mm;
}

std::optional<CanonicalSurface> asPlane(std::span<const SurfaceSpot> spots)
{
    const Vector3d centre = meanOf(spots, &SurfaceSpot::point_mm);
    const Vector3d normal = leastDirection(spots, &SurfaceSpot::point_mm, centre);
    for (const SurfaceSpot& spot : spots)
        if (!fits(std::abs((spot.point_mm - centre).dot(normal)))) return std::nullopt;
    return CanonicalSurface{SurfaceKind::Plane, centre, normal, 0, {}};
}

std::optional<CanonicalSurface> asCylinder(std::span<const SurfaceSpot> spots)
{
    const Vector3d axis = leastDirection(spots, &SurfaceSpot::normal, Vector3d::Zero());
    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u), origin = meanOf(spots, &SurfaceSpot::point_mm);
    std::vector<Vector2d> across;
    for (const SurfaceSpot& spot : spots) {
        if (std::abs(spot.normal.dot(axis)) > sameDirection) return std::nullopt;
        across.emplace_back((spot.point_mm - origin).dot(u), (spot.point_mm - origin).dot(v));
    }
    const auto circle = circleThrough(across);
    if (!circle || !fits(circle->deviation)) return std::nullopt;
    return CanonicalSurface{
        SurfaceKind::Cylinder, origin + circle->centre.x() * u + circle->centre.y() * v, axis, circle->radius, {}};
}

std::optional<CanonicalSurface> asCone(std::span<const SurfaceSpot> spots)
{
    const Vector3d mean = meanOf(spots, &SurfaceSpot::normal);
    const Vector3d axis = leastDirection(spots, &SurfaceSpot::normal, mean);
    // All tangent planes meet in the apex.
    const Vector3d origin = meanOf(spots, &SurfaceSpot::point_mm);
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    Vector3d distances = Vector3d::Zero();
    for (const SurfaceSpot& spot : spots) {
        if (std::abs((spot.normal - mean).dot(axis)) > sameDirection) return std::nullopt;
        normals += spot.normal * spot.normal.transpose();
        distances += spot.normal * spot.normal.dot(spot.point_mm - origin);
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> solver(normals);
    if (!solver.isInvertible()) return std::nullopt;
    const Vector3d apex = origin + solver.solve(distances);
    for (const SurfaceSpot& spot : spots)
        if (!fits(std::abs(spot.normal.dot(spot.point_mm - apex)))) return std::nullopt;
    return CanonicalSurface{SurfaceKind::Cone, apex, axis, 0, {}};
}

std::optional<CanonicalSurface> asSphere(std::span<const SurfaceSpot> spots)
{
    const Vector3d origin = meanOf(spots, &SurfaceSpot::point_mm);
    Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const SurfaceSpot& spot : spots) {
        const Eigen::Matrix3d project = Eigen::Matrix3d::Identity() - spot.normal * spot.normal.transpose();
        across += project;
        right += project * (spot.point_mm - origin);
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> solver(across);
    if (!solver.isInvertible()) return std::nullopt;
    const Vector3d centre = origin + solver.solve(right);
    double radius = 0;
    for (const SurfaceSpot& spot : spots) radius += (spot.point_mm - centre).norm() / static_cast<double>(spots.size());
    for (const SurfaceSpot& spot : spots)
        if (!fits(std::abs((spot.point_mm - centre).norm() - radius))) return std::nullopt;
    if (!(radius < largestRadius_mm)) return std::nullopt;
    return CanonicalSurface{SurfaceKind::Sphere, centre, Vector3d::UnitZ(), radius, centre};
}

std::optional<CanonicalSurface> asRevolvedArc(std::span<const SurfaceSpot> spots, const Vector3d& inner_mm)
{
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    const Vector3d origin = meanOf(spots, &SurfaceSpot::point_mm);
    double size = 0;
    for (const SurfaceSpot& spot : spots) size = std::max(size, (spot.point_mm - origin).norm());
    if (!(size > 0)) return std::nullopt;
    Matrix6 equations = Matrix6::Zero();
    for (const SurfaceSpot& spot : spots) {
        Eigen::Vector<double, 6> row;
        row << ((spot.point_mm - origin) / size).cross(spot.normal), spot.normal;
        equations += row * row.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(equations);
    if (solver.eigenvalues()[1] < separate * solver.eigenvalues()[5]) return std::nullopt;
    const Vector3d direction = solver.eigenvectors().col(0).head<3>(), moment = solver.eigenvectors().col(0).tail<3>();
    const double square = direction.squaredNorm();
    // A pitch makes it a helical surface, no direction one of translation.
    if (square < sameDirection || std::abs(direction.dot(moment)) > sameDirection * square) return std::nullopt;
    const Vector3d axis = direction.normalized(), point = origin + size * direction.cross(moment) / square;
    const auto radialOf = [&](const Vector3d& p) -> Vector3d {
        const Vector3d d = p - point;
        return d - d.dot(axis) * axis;
    };
    std::vector<Vector2d> meridian;
    for (const SurfaceSpot& spot : spots)
        meridian.emplace_back((spot.point_mm - point).dot(axis), radialOf(spot.point_mm).norm());
    const auto circle = circleThrough(meridian);
    const Vector3d radial = radialOf(inner_mm);
    if (!circle || !fits(circle->deviation) || !(radial.norm() > 0)) return std::nullopt;
    return CanonicalSurface{SurfaceKind::RevolvedArc, point, axis, circle->radius,
                            point + circle->centre.x() * axis + circle->centre.y() * radial.normalized()};
}

}  // namespace

std::optional<CanonicalSurface> canonicalSurface(std::span<const SurfaceSpot> spots, const Vector3d& inner_mm)
{
    if (spots.size() < fewestSpots) return std::nullopt;
    for (const auto as : {asPlane, asCylinder, asCone, asSphere})
        if (auto found = as(spots)) return found;
    return asRevolvedArc(spots, inner_mm);
}

}  // namespace lathelier::cad
