#include "engine/form/circle/circle_least_squares.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/random.h"

namespace lathelier::form {
namespace {

constexpr Eigen::Index circleBlockSize = 512;
constexpr std::size_t circlePointsPerTask = 1 << 15;
constexpr Eigen::Index enoughToBegin = 8192;  ///< points used for the start values, so that the full set is traversed
                                              ///< only twice

/// Coordinates centred at 0 and scaled to order 1.
using Coordinates = Eigen::Ref<const Eigen::ArrayXd>;

/// The sums of one pass: half the gradient and half the Hessian of Σ(d - R)² in centre and radius.
struct CircleSums {
    double squares = 0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();       ///< for Newton's method
    Eigen::Matrix3d gauss_newton = Eigen::Matrix3d::Zero();  ///< Gauss-Newton approximation, positive semidefinite

    CircleSums operator+(const CircleSums& other) const
    {
        return {squares + other.squares, gradient + other.gradient, hessian + other.hessian,
                gauss_newton + other.gauss_newton};
    }
};

/// Of the points from `first` to `last`.
CircleSums circleSumsOf(const Coordinates& x, const Coordinates& y, const Eigen::Vector3d& circle, Eigen::Index first,
                        Eigen::Index last)
{
    using Block = Eigen::Array<double, circleBlockSize, 1>;
    Block ux, uy, e, q;
    CircleSums s;
    double sum_e = 0, sum_x = 0, sum_y = 0, sum_eq = 0, xx = 0, xy = 0, yy = 0, qxx = 0, qxy = 0, qyy = 0, ex = 0,
           ey = 0;
    for (Eigen::Index begin = first; begin < last; begin += circleBlockSize) {
        const Eigen::Index n = std::min(circleBlockSize, last - begin);
        ux.head(n) = x.segment(begin, n) - circle[0];
        uy.head(n) = y.segment(begin, n) - circle[1];
        e.head(n) = (ux.head(n).square() + uy.head(n).square()).sqrt().max(1e-300);  // a point on the centre: u = 0
        q.head(n) = e.head(n).inverse();
        ux.head(n) *= q.head(n);
        uy.head(n) *= q.head(n);
        e.head(n) -= circle[2];
        q.head(n) *= e.head(n);  // (d - R) / d
        s.squares += e.head(n).square().sum();
        sum_e += e.head(n).sum();
        sum_x += ux.head(n).sum();
        sum_y += uy.head(n).sum();
        ex += (e.head(n) * ux.head(n)).sum();
        ey += (e.head(n) * uy.head(n)).sum();
        xx += ux.head(n).square().sum();
        xy += (ux.head(n) * uy.head(n)).sum();
        yy += uy.head(n).square().sum();
        sum_eq += q.head(n).sum();
        qxx += (q.head(n) * ux.head(n).square()).sum();
        qxy += (q.head(n) * ux.head(n) * uy.head(n)).sum();
        qyy += (q.head(n) * uy.head(n).square()).sum();
    }
    const auto count = static_cast<double>(last - first);
    s.gradient = {-ex, -ey, -sum_e};
    s.gauss_newton << xx, xy, sum_x, xy, yy, sum_y, sum_x, sum_y, count;
    s.hessian = s.gauss_newton;
    s.hessian(0, 0) += sum_eq - qxx;
    s.hessian(0, 1) -= qxy;
    s.hessian(1, 0) -= qxy;
    s.hessian(1, 1) += sum_eq - qyy;
    return s;
}

CircleSums circleSumsAt(const Coordinates& x, const Coordinates& y, const Eigen::Vector3d& circle)
{
    return parallelReduce(
        static_cast<std::size_t>(x.size()), circlePointsPerTask, {}, CircleSums(),
        [&](std::size_t begin, std::size_t end) {
            return circleSumsOf(x, y, circle, static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end));
        },
        [](const CircleSums& all, const CircleSums& part) { return all + part; });
}

/// The circle that minimises Σ(d² - R²)²: start value for the geometric fit.
Eigen::Vector3d algebraicCircle(const Coordinates& all_x, const Coordinates& all_y)
{
    const double mx = all_x.mean(), my = all_y.mean();
    const Eigen::ArrayXd x = all_x - mx, y = all_y - my, z = x.square() + y.square();
    Eigen::Matrix2d m;
    m << x.square().sum(), (x * y).sum(), (x * y).sum(), y.square().sum();
    const Eigen::Vector2d centre = 0.5 * m.ldlt().solve(Eigen::Vector2d((x * z).sum(), (y * z).sum()));
    return {centre.x() + mx, centre.y() + my, std::sqrt(centre.squaredNorm() + z.mean())};
}

constexpr double runawayCircle = 1e7;  ///< radius in half sizes of the points; their sagitta is then lost in rounding

struct Found {
    Eigen::Vector3d circle;
    double squares = 0;  ///< sum of (d - R)²

    bool isCircle() const { return circle.allFinite() && std::abs(circle[2]) <= runawayCircle; }
};

/// Newton's method from `circle`.
Found minimise(const Coordinates& x, const Coordinates& y, Eigen::Vector3d circle)
{
    CircleSums now = circleSumsAt(x, y, circle);
    double damping = 0;
    for (int iteration = 0; iteration < 200; ++iteration) {
        Eigen::Matrix3d matrix = now.hessian;
        Eigen::LLT<Eigen::Matrix3d> factors(matrix);
        const bool newton = damping == 0 && factors.info() == Eigen::Success;
        if (!newton) {
            matrix = now.gauss_newton;
            matrix.diagonal() *= 1 + damping;
            factors.compute(matrix);
        }
        const Eigen::Vector3d step = factors.solve(-now.gradient);
        if (!step.allFinite()) break;
        const Eigen::Vector3d trial = circle + step;
        // The remaining step is of the size of rounding, as is the deviation of the sum of squares from its quadratic
        // model.
        if (newton && step.norm() <= 1e-9 * std::abs(circle[2]))
            return {trial, std::max(0.0, now.squares + now.gradient.dot(step))};
        const CircleSums next = circleSumsAt(x, y, trial);
        const bool fine = step.norm() <= 1e-8 * std::abs(circle[2]);  // quadratic convergence: the next Newton step
                                                                      // squares this error
        if (next.squares <= now.squares || fine) {
            circle = trial;
            now = next;
            damping = damping > 1e-6 ? damping / 10 : 0;
            if (fine) break;
        } else {
            damping = std::max(10 * damping, 1e-4);
            if (damping > 1e12) break;
        }
        if (std::abs(circle[2]) > runawayCircle) break;
    }
    // One more step without line search: Newton completes what Gauss-Newton left.
    if (const Eigen::LLT<Eigen::Matrix3d> factors(now.hessian); factors.info() == Eigen::Success) {
        const Eigen::Vector3d step = factors.solve(-now.gradient);
        if (step.norm() <= 1e-6 * std::abs(circle[2])) {
            circle += step;
            now = circleSumsAt(x, y, circle);
        }
    }
    return {circle, now.squares};
}

/// Start value: the circle of a subset, if there are many points.
Eigen::Vector3d firstCircle(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y)
{
    const Eigen::Index stride = x.size() / enoughToBegin;
    if (stride < 4) return algebraicCircle(x, y);
    const Eigen::Index count = x.size() / stride;
    Eigen::ArrayXd some_x(count), some_y(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        // At a random place of its stretch, so that a period equal to the stride is not aliased.
        const std::uint64_t drawn = randomBits(1, 0, static_cast<std::uint64_t>(i));
        const Eigen::Index place = i * stride + static_cast<Eigen::Index>(drawn % static_cast<std::uint64_t>(stride));
        some_x[i] = x[place];
        some_y[i] = y[place];
    }
    const Found found = minimise(some_x, some_y, algebraicCircle(some_x, some_y));
    return found.isCircle() ? found.circle : algebraicCircle(x, y);
}

}  // namespace

LeastSquaresCircle leastSquaresCircle(const CirclePoints& points)
{
    const Found found = minimise(points.x(), points.y(), firstCircle(points.x(), points.y()));
    if (!found.isCircle()) throw Error(errors::pointsDegenerate, {{"found", LT_TEXT("Engine", "on a line")}});
    return {found.circle.head<2>(), found.circle[2], std::sqrt(found.squares / static_cast<double>(points.size()))};
}

}  // namespace lathelier::form
