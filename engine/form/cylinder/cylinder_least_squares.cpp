#include "engine/form/cylinder/cylinder_least_squares.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/point_spread.h"
#include "engine/core/random.h"
#include "engine/form/largest_coordinate.h"

namespace lathelier::form {
namespace {

using Eigen::Vector3d;
using Vector5d = Eigen::Vector<double, 5>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;

constexpr double runawayCylinder = 1e5;  // radius over extent beyond which the points are taken as planar

struct CylinderSums {
    double squares = 0;
    Vector5d gradient = Vector5d::Zero();
    Matrix5d matrix = Matrix5d::Zero();

    CylinderSums& operator+=(const CylinderSums& other)
    {
        squares += other.squares;
        gradient += other.gradient;
        matrix += other.matrix;
        return *this;
    }
};

CylinderSums cylinderSumsAt(const CylinderPoints& points, const AxisParameters& axis, double radius,
                            const Progress& progress)
{
    return parallelReduce(
        points.size(), 16384, progress, CylinderSums{},
        [&](std::size_t begin, std::size_t end) {
            CylinderSums part;
            for (std::size_t i = begin; i < end; ++i) {
                const AxisDistance d = distanceFrom(axis, points.point(i));
                Vector5d row;
                row << d.gradient, -1;
                const double residual = d.distance - radius;
                part.squares += residual * residual;
                part.gradient += residual * row;
                part.matrix.triangularView<Eigen::Lower>() += row * row.transpose();
            }
            return part;
        },
        [](CylinderSums all, const CylinderSums& part) { return all += part; });
}

/// Circle of the points as seen along z, and its residual.
LeastSquaresCylinder circleAlongAxis(const CylinderPoints& points)
{
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d p = points.point(i), row(p.x(), p.y(), 1);
        m += row * row.transpose();
        right += row * p.head<2>().squaredNorm();
    }
    const Vector3d solution = m.ldlt().solve(right);
    LeastSquaresCylinder result;
    result.axis << 0.5 * solution.x(), 0.5 * solution.y(), 0, 0;
    result.radius = std::sqrt(std::max(solution.z() + result.axis.head<2>().squaredNorm(), 0.0));
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double residual = (points.point(i).head<2>() - result.axis.head<2>()).norm() - result.radius;
        squares += residual * residual;
    }
    result.rms = std::sqrt(squares / static_cast<double>(points.size()));
    if (!(result.radius < runawayCylinder)) result.rms = std::numeric_limits<double>::infinity();
    return result;
}

/// Principal axes first, then directions spread over the half sphere.
std::vector<Vector3d> directionsToTry(const Eigen::Matrix3d& axes)
{
    std::vector<Vector3d> directions{axes.col(0), axes.col(1), axes.col(2)};
    constexpr int spread = 120;
    for (int k = 0; k < spread; ++k) {
        const double z = (k + 0.5) / spread, r = std::sqrt(1 - z * z),
                     turn = std::numbers::pi * (3 - std::sqrt(5.0)) * k;
        directions.push_back(axes * Vector3d(r * std::cos(turn), r * std::sin(turn), z));
    }
    return directions;
}

}  // namespace

LeastSquaresCylinder leastSquaresCylinder(const CylinderPoints& points, const LeastSquaresCylinder& start,
                                          const Progress& progress)
{
    LeastSquaresCylinder fit = start;
    CylinderSums now = cylinderSumsAt(points, fit.axis, fit.radius, progress);
    double damping = 0, last_size = 1;
    constexpr int mostSteps = 200;
    for (int iteration = 0; iteration < mostSteps; ++iteration) {
        Matrix5d matrix = now.matrix.selfadjointView<Eigen::Lower>();
        matrix.diagonal() *= 1 + damping + 1e-15;
        const Vector5d step = matrix.ldlt().solve(-now.gradient);
        if (!step.allFinite() || !(step.norm() < 1e12)) break;
        const AxisParameters axis = fit.axis + step.head<4>();
        const double radius = fit.radius + step[4];
        const CylinderSums next = cylinderSumsAt(points, axis, radius, progress);
        const double size = step.norm() / (1 + radius);
        // Near convergence the sum of squares is constant to rounding: full steps are taken there, and their length is
        // the criterion.
        const bool fine = size < 1e-7;
        if (next.squares <= now.squares || (fine && damping == 0 && size < 0.7 * last_size)) {
            fit.axis = axis;
            fit.radius = radius;
            now = next;
            last_size = damping == 0 ? size : 1;
            damping = !fine && damping > 1e-6 ? damping / 10 : 0;
            fit.converged = last_size < 1e-14;
        } else if (fine) {
            fit.converged = damping == 0;
            damping = 0;
        } else {
            damping = std::max(10 * damping, 1e-4);
        }
        if (fit.converged) break;
        if (damping > 1e10) break;
    }
    fit.converged = fit.converged && std::abs(fit.radius) < runawayCylinder;
    fit.rms = std::sqrt(now.squares / static_cast<double>(points.size()));
    return fit;
}

CylinderGuess guessCylinder(std::span<const Vector3d> points_mm, const Progress& progress)
{
    const PointSpread spread = spreadOf(points_mm, 6, largestCoordinate_mm, progress);
    refuseDegenerate(spread, 1e-14 * spread.largest_mm, 1e-7 * spread.extent_mm[2] + 1e-14 * spread.largest_mm);
    const double size_mm = 2 * spread.extent_mm[2];
    constexpr std::size_t enough = 400;
    std::vector<Vector3d> some;
    if (points_mm.size() <= enough)
        some.assign(points_mm.begin(), points_mm.end());
    else
        for (std::size_t i = 0; i < enough; ++i) some.push_back(points_mm[randomBits(1, 0, i) % points_mm.size()]);

    std::vector<std::pair<double, Vector3d>> trials;
    for (const Vector3d& direction : directionsToTry(spread.axes))
        trials.emplace_back(circleAlongAxis(CylinderPoints(some, spread.mean_mm, direction, size_mm)).rms, direction);
    std::stable_sort(trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    constexpr std::size_t refined = 8;
    CylinderGuess guess{spread.mean_mm, spread.axes.col(2), size_mm, {}};
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < refined; ++k) {
        Vector3d direction = trials[k].second;
        // The parametrisation holds for axes near z: rotate the coordinates until the axis found is parallel to z.
        constexpr int mostTurns = 6;
        for (int turn = 0; turn < mostTurns; ++turn) {
            progress.check();
            const CylinderPoints points(some, spread.mean_mm, direction, size_mm);
            const LeastSquaresCylinder fit = leastSquaresCylinder(points, circleAlongAxis(points), progress);
            const Vector3d next = points.directionOf(fit.axis);
            if (!next.allFinite() || !(std::abs(fit.radius) < runawayCylinder)) break;
            if (next.dot(direction) > 0.9999) {
                if (fit.rms < best) {
                    best = fit.rms;
                    guess.direction = direction;
                    guess.cylinder = fit;
                }
                break;
            }
            direction = next;
        }
    }
    if (!std::isfinite(best)) throw Error(errors::notConverged, {{"iterations", std::int64_t{200}}});
    return guess;
}

}  // namespace lathelier::form
