#include "engine/registration/surface_patch.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lathelier::registration {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double min_points_of_quadric = 9;

}  // namespace

double SurfacePatch::distance_mm(const Eigen::Vector3d& point_mm) const
{
    const Eigen::Vector3d d = point_mm - centre_mm;
    const double h = d.dot(normal);
    const double x = d.dot(u);
    const double y = d.dot(v);
    const double sx = c[1] + 2 * c[3] * x + c[4] * y;
    const double sy = c[2] + c[4] * x + 2 * c[5] * y;
    const double off = h - (c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y);
    return off / std::sqrt(1 + sx * sx + sy * sy);
}

Eigen::Vector3d SurfacePatch::normalAt(const Eigen::Vector3d& point_mm) const
{
    const Eigen::Vector3d d = point_mm - centre_mm;
    const double x = d.dot(u);
    const double y = d.dot(v);
    const double sx = c[1] + 2 * c[3] * x + c[4] * y;
    const double sy = c[2] + c[4] * x + 2 * c[5] * y;
    return (normal - sx * u - sy * v) / std::sqrt(1 + sx * sx + sy * sy);
}

double SurfacePatch::lateral_mm(const Eigen::Vector3d& point_mm) const
{
    const Eigen::Vector3d d = point_mm - centre_mm;
    return std::hypot(d.dot(u), d.dot(v));
}

double SurfacePatch::slopeVariance(const Eigen::Vector3d& point_mm) const
{
    // The inverse of the normal equations of the quadric on a disc of radius 1, mean over both directions.
    const double t = lateral_mm(point_mm) / radius_mm;
    const double curved = c.tail<3>().isZero(0) ? 0 : 48 * t * t;
    return sigma_mm * sigma_mm * (4 + curved) / (radius_mm * radius_mm * points);
}

void SurfacePatch::flip()
{
    normal = -normal;
    std::swap(u, v);
    c = -c;
    std::swap(c[1], c[2]);
    std::swap(c[3], c[5]);
}

SurfacePatch fitPatch(std::span<const Eigen::Vector3d> points_mm, std::span<const double> weights)
{
    SurfacePatch patch;
    double total = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const Eigen::Vector3d& origin = points_mm[0];
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        total += weights[i];
        sum += weights[i] * (points_mm[i] - origin);
    }
    patch.points = total;
    if (!(total > 0)) return patch;
    patch.centre_mm = origin + sum / total;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    double reach = 0;
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        if (weights[i] == 0) continue;
        const Eigen::Vector3d d = points_mm[i] - patch.centre_mm;
        spread += weights[i] * d * d.transpose();
        reach = std::max(reach, d.squaredNorm());
    }
    patch.radius_mm = std::sqrt(reach);
    if (!(reach > 0)) return patch;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(spread / spread.trace());
    patch.breadth = std::sqrt(std::max(0.0, axes.eigenvalues()[1]) / axes.eigenvalues()[2]);
    patch.normal = axes.eigenvectors().col(0);
    patch.u = axes.eigenvectors().col(2);
    patch.v = patch.normal.cross(patch.u).normalized();
    patch.u = patch.v.cross(patch.normal).normalized();

    double squares = 0;
    double parameters = 3;
    if (total >= min_points_of_quadric) {
        Matrix6 h = Matrix6::Zero();
        Vector6 g = Vector6::Zero();
        const double scale = 1 / patch.radius_mm;
        for (std::size_t i = 0; i < points_mm.size(); ++i) {
            if (weights[i] == 0) continue;
            const Eigen::Vector3d d = (points_mm[i] - patch.centre_mm) * scale;
            const double x = d.dot(patch.u);
            const double y = d.dot(patch.v);
            Vector6 row;
            row << 1, x, y, x * x, x * y, y * y;
            h.noalias() += (weights[i] * row) * row.transpose();
            g += weights[i] * d.dot(patch.normal) * row;
        }
        const Eigen::LDLT<Matrix6> solver(h);
        const Vector6 pivots = solver.vectorD();
        if (pivots.minCoeff() > 2e-3 * pivots.maxCoeff()) {
            const Vector6 s = solver.solve(g);
            patch.c << s[0] * patch.radius_mm, s[1], s[2], s[3] * scale, s[4] * scale, s[5] * scale;
            parameters = 6;
        }
    }
    for (std::size_t i = 0; i < points_mm.size(); ++i)
        if (weights[i] != 0) {
            const double off = patch.distance_mm(points_mm[i]);
            squares += weights[i] * off * off;
        }
    patch.sigma_mm = std::sqrt(squares / std::max(1.0, total - parameters));
    return patch;
}

std::size_t fitRobustPatch(std::span<const Eigen::Vector3d> points_mm, double sigma_mm, int rounds, SurfacePatch& patch)
{
    std::vector<double> weights(points_mm.size());
    std::size_t count = 0;
    for (int round = 0; round < rounds; ++round) {
        count = 0;
        for (std::size_t i = 0; i < points_mm.size(); ++i) {
            const double t = patch.distance_mm(points_mm[i]) / (4.685 * sigma_mm);
            weights[i] = t * t < 1 ? (1 - t * t) * (1 - t * t) : 0;
            if (weights[i] > 0) ++count;
        }
        if (count < 4) return count;
        const Eigen::Vector3d normal = patch.normal;
        patch = fitPatch(points_mm, weights);
        if (patch.normal.dot(normal) < 0) patch.flip();
    }
    return count;
}

}  // namespace lathelier::registration
