#include "engine/registration/revolution/revolution_guess.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/core/statistics.h"
#include "engine/registration/neighbours/neighbours.h"

namespace lathelier::registration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t normalSamples = 800;
constexpr std::size_t planeNeighbours = 14;

struct OrientedPoint {
    Vector3d point;
    Vector3d normal;
    double scatter_mm = 0;
};

/// Normals of a few points from planes through their nearest neighbours.
std::vector<OrientedPoint> estimateNormals(const std::vector<Vector3d>& points, const Progress& progress)
{
    const std::size_t count = std::min(normalSamples, points.size());
    const std::size_t neighbours = std::min(planeNeighbours, points.size());
    const Neighbours index(points, progress);
    std::vector<OrientedPoint> result(count);
    parallelFor(count, 16, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbours::Found> nearest;
        for (std::size_t i = begin; i < end; ++i) {
            index.nearest(points[i * points.size() / count], neighbours, std::numeric_limits<double>::infinity(),
                          nearest);
            Vector3d mean = Vector3d::Zero();
            for (std::size_t k = 0; k < neighbours; ++k) mean += index.point_mm(nearest[k].place);
            mean /= static_cast<double>(neighbours);
            Matrix3d scatter = Matrix3d::Zero();
            for (std::size_t k = 0; k < neighbours; ++k) {
                const Vector3d off = index.point_mm(nearest[k].place) - mean;
                scatter += off * off.transpose();
            }
            const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(scatter);
            const double freedom = std::max(1.0, static_cast<double>(neighbours) - 3);
            result[i] = {mean, eigen.eigenvectors().col(0), std::sqrt(std::max(0.0, eigen.eigenvalues()[0]) / freedom)};
        }
    });
    return result;
}

struct Line {
    Vector3d point;
    Vector3d direction;
};

/// Sine of the angle by which rotation about `line` would push the surface along its normal; 0 on a surface of
/// revolution. Near the axis, where the angle is ill-defined, the lever is bounded below by `least_lever`.
double slip(const OrientedPoint& p, const Line& line, double least_lever)
{
    const Vector3d motion = line.direction.cross(p.point - line.point);
    return p.normal.dot(motion) / std::max(motion.norm(), least_lever);
}

/// Weighted linear complex. With the moment m eliminated, the direction is the eigenvector of the smallest eigenvalue;
/// the component of m along the direction is set to 0 (a cylinder does not determine it).
Line solveComplex(const std::vector<OrientedPoint>& points, const std::vector<double>& weights, const Line& before,
                  double size)
{
    Matrix3d dd = Matrix3d::Zero(), dm = Matrix3d::Zero(), mm = Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d arm = (points[i].point - before.point).cross(points[i].normal) / size;
        dd += weights[i] * arm * arm.transpose();
        dm += weights[i] * arm * points[i].normal.transpose();
        mm += weights[i] * points[i].normal * points[i].normal.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(mm);
    Matrix3d inverse = Matrix3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (eigen.eigenvalues()[k] > 3e-3 * eigen.eigenvalues()[2])
            inverse += eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose() / eigen.eigenvalues()[k];
    const Matrix3d left = dd - dm * inverse * dm.transpose();
    const Vector3d direction =
        Eigen::SelfAdjointEigenSolver<Matrix3d>((left + left.transpose()) / 2).eigenvectors().col(0);
    const Vector3d moment = -size * (inverse * dm.transpose() * direction);
    return {before.point + direction.cross(moment), direction};
}

/// The same for a given direction: the position of the axis alone.
Line placeAxis(const std::vector<OrientedPoint>& points, const Line& start)
{
    Matrix3d sum = Matrix3d::Identity() * 1e-9;
    Vector3d right = Vector3d::Zero();
    for (const OrientedPoint& p : points) {
        const Vector3d lever = p.normal.cross(start.direction);
        sum += lever * lever.transpose();
        right += lever * lever.dot(p.point - start.point);
    }
    sum += start.direction * start.direction.transpose() * static_cast<double>(points.size());
    return {start.point + sum.ldlt().solve(right), start.direction};
}

double share(const std::vector<OrientedPoint>& points, const Line& line, double least_lever, double limit)
{
    std::size_t good = 0;
    for (const OrientedPoint& p : points)
        if (std::abs(slip(p, line, least_lever)) < limit) ++good;
    return static_cast<double>(good) / static_cast<double>(points.size());
}

Line refineAxis(const std::vector<OrientedPoint>& points, Line line, double size)
{
    std::vector<double> weights(points.size());
    double limit = 0.6;  // annealed inlier threshold
    for (int i = 0; i < 12; ++i, limit = std::max(0.12, limit * 0.75)) {
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double s = slip(points[k], line, 0.05 * size) / limit;
            const double lever =
                std::max(line.direction.cross(points[k].point - line.point).norm(), 0.05 * size) / size;
            weights[k] = std::abs(s) < 1 ? (1 - s * s) * (1 - s * s) / (lever * lever) : 0;
        }
        const Line next = solveComplex(points, weights, line, size);
        if (!next.direction.allFinite() || !next.point.allFinite()) return line;
        line = next;
    }
    return line;
}

}  // namespace

AxisCandidates findAxisCandidates(const std::vector<Vector3d>& points, const Progress& progress)
{
    const std::vector<OrientedPoint> oriented = estimateNormals(points, progress);
    Vector3d centre;  // coordinate-wise median, robust to spurious points
    for (int k = 0; k < 3; ++k) {
        std::vector<double> values(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i][k];
        centre[k] = upperMedianInPlace(values);
    }
    Matrix3d scatter = Matrix3d::Zero();
    for (const Vector3d& p : points) scatter += (p - centre) * (p - centre).transpose();
    scatter /= static_cast<double>(points.size());
    const double size = std::sqrt(scatter.trace());
    const Matrix3d principal = Eigen::SelfAdjointEigenSolver<Matrix3d>(scatter).eigenvectors();

    // Starts: the linear complex of all normals, then each principal axis; each with and without robust refinement.
    std::vector<Line> lines;
    const std::vector<double> equal(oriented.size(), 1.0);
    lines.push_back(refineAxis(oriented, solveComplex(oriented, equal, {centre, Vector3d::UnitZ()}, size), size));
    for (int k = 2; k >= 0; --k) {
        const Line placed = placeAxis(oriented, {centre, principal.col(k)});
        lines.push_back(refineAxis(oriented, placed, size));
        lines.push_back(placed);
    }
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double score =
            share(oriented, lines[i], 0.05 * size, 0.1) + 0.5 * share(oriented, lines[i], 0.05 * size, 0.03);
        order.emplace_back(-score, i);
    }
    std::stable_sort(order.begin(), order.end());
    AxisCandidates result;
    std::vector<double> scatters;
    scatters.reserve(oriented.size());
    for (const OrientedPoint& p : oriented) scatters.push_back(p.scatter_mm);
    const double middle = upperMedianInPlace(scatters);
    result.noise_mm = middle;
    for (const auto& [score, i] : order) {
        const Vector3d direction = lines[i].direction.normalized();
        const Vector3d foot = lines[i].point + direction * direction.dot(centre - lines[i].point);
        const bool known =
            std::any_of(result.axis_T_scan.begin(), result.axis_T_scan.end(), [&](const Eigen::Isometry3d& other) {
                const Vector3d in_other = other * foot;
                return std::abs((other.linear() * direction).z()) > 0.9999 &&
                       std::hypot(in_other.x(), in_other.y()) < 0.01 * size;
            });
        if (known || !foot.allFinite()) continue;
        Eigen::Isometry3d axis_T_scan = Eigen::Isometry3d::Identity();
        const Vector3d across = direction.unitOrthogonal();
        axis_T_scan.linear() << across.transpose(), direction.cross(across).transpose(), direction.transpose();
        axis_T_scan.translation() = -(axis_T_scan.linear() * foot);
        result.axis_T_scan.push_back(axis_T_scan);
    }
    return result;
}

}  // namespace lathelier::registration
