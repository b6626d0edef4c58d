#include "engine/registration/surface/surface_patch.h"

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

constexpr double leastQuadricPoints = 9;

// Two points at once (SIMD).
using Pair = Eigen::Array2d;

struct Pairs {
    Pair x;
    Pair y;
    Pair z;
};

// Coordinates along three directions, from an origin, of the points i and i + 1; of the last one alone twice.
class PatchFrame {
public:
    PatchFrame(std::span<const Eigen::Vector3d> points_mm, const Eigen::Vector3d& origin_mm,
               const Eigen::Matrix3d& rows)
        : points_mm_(points_mm), origin_mm_(origin_mm), rows_(rows)
    {
    }

    Pairs at(std::size_t i) const
    {
        const Eigen::Vector3d& a = points_mm_[i];
        const Eigen::Vector3d& b = points_mm_[std::min(i + 1, points_mm_.size() - 1)];
        const Pair dx = Pair(a.x(), b.x()) - origin_mm_.x();
        const Pair dy = Pair(a.y(), b.y()) - origin_mm_.y();
        const Pair dz = Pair(a.z(), b.z()) - origin_mm_.z();
        return {rows_(0, 0) * dx + rows_(0, 1) * dy + rows_(0, 2) * dz,
                rows_(1, 0) * dx + rows_(1, 1) * dy + rows_(1, 2) * dz,
                rows_(2, 0) * dx + rows_(2, 1) * dy + rows_(2, 2) * dz};
    }

private:
    std::span<const Eigen::Vector3d> points_mm_;
    Eigen::Vector3d origin_mm_;
    Eigen::Matrix3d rows_;
};

Pair weightsAt(std::span<const double> weights, std::size_t i)
{
    return {weights[i], i + 1 < weights.size() ? weights[i + 1] : 0};
}

// The least-squares quadric z = s0 + s1 x + s2 y + s3 x² + s4 xy + s5 y²; false where the points do not determine all
// six.
bool fitQuadric(const PatchFrame& frame, std::span<const double> weights, Vector6& s)
{
    // Sums of x^i y^j for i + j up to 4, and of z x^i y^j up to 2, in the order of the powers below.
    std::array<Pair, 15> sums;
    std::array<Pair, 6> z_sums;
    sums.fill(Pair::Zero());
    z_sums.fill(Pair::Zero());
    for (std::size_t i = 0; i < weights.size(); i += 2) {
        const Pair w = weightsAt(weights, i);
        const auto [x, y, z] = frame.at(i);
        const Pair wx = w * x;
        const Pair wy = w * y;
        const Pair xx = wx * x;
        const Pair xy = wx * y;
        const Pair yy = wy * y;
        const Pair xxx = xx * x;
        const Pair xxy = xx * y;
        const Pair xyy = yy * x;
        const Pair yyy = yy * y;
        sums[0] += w;
        sums[1] += wx;
        sums[2] += wy;
        sums[3] += xx;
        sums[4] += xy;
        sums[5] += yy;
        sums[6] += xxx;
        sums[7] += xxy;
        sums[8] += xyy;
        sums[9] += yyy;
        sums[10] += xxx * x;
        sums[11] += xxx * y;
        sums[12] += xxy * y;
        sums[13] += xyy * y;
        sums[14] += yyy * y;
        z_sums[0] += w * z;
        z_sums[1] += wx * z;
        z_sums[2] += wy * z;
        z_sums[3] += xx * z;
        z_sums[4] += xy * z;
        z_sums[5] += yy * z;
    }
    constexpr std::array<std::array<std::size_t, 6>, 6> places = {{{0, 1, 2, 3, 4, 5},
                                                                   {1, 3, 4, 6, 7, 8},
                                                                   {2, 4, 5, 7, 8, 9},
                                                                   {3, 6, 7, 10, 11, 12},
                                                                   {4, 7, 8, 11, 12, 13},
                                                                   {5, 8, 9, 12, 13, 14}}};
    Matrix6 h;
    Vector6 g;
    for (std::size_t row = 0; row < 6; ++row) {
        for (std::size_t column = 0; column < 6; ++column)
            h(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = sums[places[row][column]].sum();
        g[static_cast<Eigen::Index>(row)] = z_sums[row].sum();
    }
    const Eigen::LDLT<Matrix6> solver(h);
    const Vector6 pivots = solver.vectorD();
    if (!(pivots.minCoeff() > 2e-3 * pivots.maxCoeff())) return false;
    s = solver.solve(g);
    return true;
}

// Weighted sum of the squares of the distances from z = s0 + s1 x + …, to second order in the slope.
double sumOfSquares(const PatchFrame& frame, std::span<const double> weights, const Vector6& s)
{
    Pair sum = Pair::Zero();
    for (std::size_t i = 0; i < weights.size(); i += 2) {
        const auto [x, y, z] = frame.at(i);
        const Pair sx = s[1] + 2 * s[3] * x + s[4] * y;
        const Pair sy = s[2] + s[4] * x + 2 * s[5] * y;
        const Pair off = z - (s[0] + x * (s[1] + s[3] * x + s[4] * y) + y * (s[2] + s[5] * y));
        sum += weightsAt(weights, i) * off * off / (1 + sx * sx + sy * sy);
    }
    return sum.sum();
}

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
    const double x = d.dot(u);
    const double y = d.dot(v);
    return std::sqrt(x * x + y * y);
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
    std::array<Pair, 6> squares;
    squares.fill(Pair::Zero());
    Pair reaches = Pair::Zero();
    const PatchFrame about(points_mm, patch.centre_mm, Eigen::Matrix3d::Identity());
    for (std::size_t i = 0; i < points_mm.size(); i += 2) {
        const Pair w = weightsAt(weights, i);
        const auto [x, y, z] = about.at(i);
        const Pair xx = x * x;
        const Pair yy = y * y;
        const Pair zz = z * z;
        squares[0] += w * xx;
        squares[1] += w * yy;
        squares[2] += w * zz;
        squares[3] += w * x * y;
        squares[4] += w * x * z;
        squares[5] += w * y * z;
        reaches = reaches.max((w > 0).select(xx + yy + zz, 0));
    }
    const double reach = reaches.maxCoeff();
    patch.radius_mm = std::sqrt(reach);
    if (!(reach > 0)) return patch;
    Eigen::Matrix3d spread;
    spread << squares[0].sum(), squares[3].sum(), squares[4].sum(), squares[3].sum(), squares[1].sum(),
        squares[5].sum(), squares[4].sum(), squares[5].sum(), squares[2].sum();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(spread / spread.trace());
    patch.breadth = std::sqrt(std::max(0.0, axes.eigenvalues()[1]) / axes.eigenvalues()[2]);
    patch.normal = axes.eigenvectors().col(0);
    patch.u = axes.eigenvectors().col(2);
    patch.v = patch.normal.cross(patch.u).normalized();
    patch.u = patch.v.cross(patch.normal).normalized();

    const double scale = 1 / patch.radius_mm;
    Eigen::Matrix3d rows;
    rows << patch.u.transpose(), patch.v.transpose(), patch.normal.transpose();
    const PatchFrame frame(points_mm, patch.centre_mm, scale * rows);
    Vector6 s = Vector6::Zero();
    const bool is_quadric = total >= leastQuadricPoints && fitQuadric(frame, weights, s);
    patch.c << s[0] * patch.radius_mm, s[1], s[2], s[3] * scale, s[4] * scale, s[5] * scale;
    patch.sigma_mm =
        patch.radius_mm * std::sqrt(sumOfSquares(frame, weights, s) / std::max(1.0, total - (is_quadric ? 6 : 3)));
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
