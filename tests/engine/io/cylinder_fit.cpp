#include "tests/engine/io/cylinder_fit.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <numbers>

namespace lathelier::testing {
namespace {

using Points = std::vector<Eigen::Vector3d>;

struct Cylinder {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    double radius = 0;
};

/// Two unit vectors across the axis.
Eigen::Matrix<double, 3, 2> across(const Eigen::Vector3d& axis)
{
    Eigen::Matrix<double, 3, 2> basis;
    basis.col(0) = axis.unitOrthogonal();
    basis.col(1) = axis.cross(basis.col(0));
    return basis;
}

Eigen::VectorXd distances(const Points& points, const Cylinder& c)
{
    Eigen::VectorXd d(static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d v = points[i] - c.point;
        d[static_cast<Eigen::Index>(i)] = (v - v.dot(c.axis) * c.axis).norm() - c.radius;
    }
    return d;
}

/// The algebraic circle (I. Kåsa, 1976) through the points seen along `axis`.
Cylinder alongAxis(const Points& points, const Eigen::Vector3d& axis)
{
    const auto basis = across(axis);
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd a(n, 3);
    Eigen::VectorXd b(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Vector2d p = basis.transpose() * points[static_cast<std::size_t>(i)];
        a.row(i) << 2 * p.x(), 2 * p.y(), 1;
        b[i] = p.squaredNorm();
    }
    const Eigen::Vector3d s = a.colPivHouseholderQr().solve(b);
    return {basis * s.head<2>(), axis, std::sqrt(std::max(0.0, s[2] + s.head<2>().squaredNorm()))};
}

}  // namespace

double cylinderDiameter(const Points& points)
{
    Cylinder best;
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 40; ++i)
        for (int k = 0; k < 40; ++k) {
            const double z = (i + 0.5) / 40;
            const double turn = 2 * std::numbers::pi * k / 40;
            const double r = std::sqrt(1 - z * z);
            const Cylinder c = alongAxis(points, {r * std::cos(turn), r * std::sin(turn), z});
            const double sum = distances(points, c).squaredNorm();
            if (sum < smallest) smallest = sum, best = c;
        }
    // Gauss-Newton over two tilts, two shifts and the radius.
    for (int iteration = 0; iteration < 100; ++iteration) {
        const auto basis = across(best.axis);
        const auto n = static_cast<Eigen::Index>(points.size());
        Eigen::MatrixXd j(n, 5);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Vector3d v = points[static_cast<std::size_t>(i)] - best.point;
            const double along = v.dot(best.axis);
            const Eigen::Vector3d out = (v - along * best.axis).normalized();
            const Eigen::Vector2d o = basis.transpose() * out;
            j.row(i) << -along * o.x(), -along * o.y(), -o.x(), -o.y(), -1;
        }
        const Eigen::VectorXd step = j.colPivHouseholderQr().solve(-distances(points, best));
        best.axis = (best.axis + basis * step.head<2>()).normalized();
        best.point += basis * step.segment<2>(2);
        best.radius += step[4];
        if (step.norm() < 1e-13) break;
    }
    return 2 * best.radius;
}

}  // namespace lathelier::testing
