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

/// Normals, robust refinement and choice of the starts (README, "Thresholds").
struct AxisGuessThresholds {
    std::size_t normals = 800;          ///< places with a normal
    std::size_t plane_neighbours = 14;  ///< points of the plane through each of them
    double least_eigenvalue = 3e-3;     ///< of the normals' scatter, over the largest: below it the moment is free
    double placing_weight = 1e-9;       ///< holds the start along what the normals do not determine
    double first_slip = 0.6;            ///< sine of the angle at which a normal counts nothing, in the first round;
    double slip_shrinkage = 0.75;       ///< in each further round times this (annealing),
    double last_slip = 0.12;            ///< down to this
    int refining_rounds = 12;
    double least_lever = 0.05;    ///< of the size: nearer to the axis the angle of a normal is not defined
    double good_slip = 0.1;       ///< sine of the angle up to which a normal agrees with an axis,
    double best_slip = 0.03;      ///< and up to which it counts half as much again
    double same_cosine = 0.9999;  ///< between two axes that are one,
    double same_distance = 0.01;  ///< of the size, likewise
};
constexpr AxisGuessThresholds guessThresholds{};

constexpr double planeFreedoms = 3;         // of a plane through points
constexpr std::size_t normalsPerTask = 16;  // places of one task

struct OrientedPoint {
    Vector3d point;
    Vector3d normal;
    double scatter_mm = 0;
};

/// Normals of a few points from planes through their nearest neighbours.
std::vector<OrientedPoint> estimateNormals(const std::vector<Vector3d>& points, const Progress& progress)
{
    const std::size_t count = std::min(guessThresholds.normals, points.size());
    const std::size_t neighbours = std::min(guessThresholds.plane_neighbours, points.size());
    const Neighbours index(points, progress);
    std::vector<OrientedPoint> result(count);
    parallelFor(count, normalsPerTask, progress, [&](std::size_t begin, std::size_t end) {
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
            const double freedom = std::max(1.0, static_cast<double>(neighbours) - planeFreedoms);
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
        if (eigen.eigenvalues()[k] > guessThresholds.least_eigenvalue * eigen.eigenvalues()[2])
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
    Matrix3d sum = Matrix3d::Identity() * guessThresholds.placing_weight;
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
    const double least_lever = guessThresholds.least_lever * size;
    std::vector<double> weights(points.size());
    double limit = guessThresholds.first_slip;
    for (int i = 0; i < guessThresholds.refining_rounds; ++i) {
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double weight = tukeyWeight(slip(points[k], line, least_lever) / limit);
            const double lever =
                std::max(line.direction.cross(points[k].point - line.point).norm(), least_lever) / size;
            weights[k] = weight / (lever * lever);
        }
        const Line next = solveComplex(points, weights, line, size);
        if (!next.direction.allFinite() || !next.point.allFinite()) return line;
        line = next;
        limit = std::max(guessThresholds.last_slip, limit * guessThresholds.slip_shrinkage);
    }
    return line;
}

/// Middle, size and principal axes of the points.
struct CloudExtent {
    Vector3d centre;     ///< coordinate-wise median, robust to spurious points
    double size;         ///< root mean square distance from it
    Matrix3d principal;  ///< unit vectors in the columns, by growing extent
};

CloudExtent cloudExtentOf(const std::vector<Vector3d>& points)
{
    Vector3d centre;
    for (int k = 0; k < 3; ++k) {
        std::vector<double> values(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i][k];
        centre[k] = upperMedianInPlace(values);
    }
    Matrix3d scatter = Matrix3d::Zero();
    for (const Vector3d& p : points) scatter += (p - centre) * (p - centre).transpose();
    scatter /= static_cast<double>(points.size());
    return {centre, std::sqrt(scatter.trace()), Eigen::SelfAdjointEigenSolver<Matrix3d>(scatter).eigenvectors()};
}

/// Starts, best first: the linear complex of all normals, then each principal axis; each with and without robust
/// refinement.
std::vector<Line> startsOf(const std::vector<OrientedPoint>& oriented, const CloudExtent& extent)
{
    const double size = extent.size;
    std::vector<Line> lines;
    const std::vector<double> equal(oriented.size(), 1.0);
    const Line of_all = solveComplex(oriented, equal, {extent.centre, Vector3d::UnitZ()}, size);
    lines.push_back(refineAxis(oriented, of_all, size));
    for (int k = 2; k >= 0; --k) {
        const Line placed = placeAxis(oriented, {extent.centre, extent.principal.col(k)});
        lines.push_back(refineAxis(oriented, placed, size));
        lines.push_back(placed);
    }
    const double least_lever = guessThresholds.least_lever * size;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < lines.size(); ++i)
        order.emplace_back(-(share(oriented, lines[i], least_lever, guessThresholds.good_slip) +
                             0.5 * share(oriented, lines[i], least_lever, guessThresholds.best_slip)),
                           i);
    std::stable_sort(order.begin(), order.end());
    std::vector<Line> sorted;
    sorted.reserve(order.size());
    for (const auto& [score, i] : order) sorted.push_back(lines[i]);
    return sorted;
}

/// Scatter of neighbouring points about a plane: the median.
double noiseOf(const std::vector<OrientedPoint>& oriented)
{
    std::vector<double> scatters;
    scatters.reserve(oriented.size());
    for (const OrientedPoint& p : oriented) scatters.push_back(p.scatter_mm);
    return upperMedianInPlace(scatters);
}

}  // namespace

AxisCandidates findAxisCandidates(const std::vector<Vector3d>& points, const Progress& progress)
{
    const std::vector<OrientedPoint> oriented = estimateNormals(points, progress);
    const CloudExtent extent = cloudExtentOf(points);
    AxisCandidates result;
    result.noise_mm = noiseOf(oriented);
    for (const Line& line : startsOf(oriented, extent)) {
        const Vector3d direction = line.direction.normalized();
        const Vector3d foot = line.point + direction * direction.dot(extent.centre - line.point);
        const bool known =
            std::any_of(result.axis_T_scan.begin(), result.axis_T_scan.end(), [&](const Eigen::Isometry3d& other) {
                const Vector3d in_other = other * foot;
                return std::abs((other.linear() * direction).z()) > guessThresholds.same_cosine &&
                       std::hypot(in_other.x(), in_other.y()) < guessThresholds.same_distance * extent.size;
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
