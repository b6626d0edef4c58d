#include "engine/form/linear_minimax.h"

#include <Eigen/LU>
#include <cmath>

namespace lathelier::form {
namespace {

/// normal · (step / half, value) ≥ bound. Steps are scaled by half the side of the cube, so that the normals have
/// comparable length for any cube.
template <int N>
struct Constraint {
    Eigen::Vector<double, N + 1> normal = Eigen::Vector<double, N + 1>::Zero();
    double bound = 0;
    std::size_t outer = MinimaxStep<N>::none, inner = MinimaxStep<N>::none;
    bool limit = false;
};

template <int N>
class Program {
public:
    using Step = Eigen::Vector<double, N>;

    Program(const LinearDistances<N>& distances, MinimaxGoal goal, double half, const std::vector<Limit<N>>& limits)
        : distances_(distances), goal_(goal), half_(half), limits_(limits)
    {
    }

    /// The linear piece of the objective that is largest at `step`: value ≥ piece.
    Constraint<N> largestPiece(const Step& step) const
    {
        const Step s = half_ * step;
        const std::size_t count = distances_.size();
        double low = std::numeric_limits<double>::infinity(), high = -low;
        std::size_t inner = 0, outer = 0;
        for (std::size_t i = 0; i < count; ++i) {
            double value = distances_.a[i];
            for (std::size_t k = 0; k < N; ++k) value -= distances_.u[k][i] * s[static_cast<int>(k)];
            if (value < low) {
                low = value;
                inner = i;
            }
            if (value > high) {
                high = value;
                outer = i;
            }
        }
        Constraint<N> result;
        Step gradient = Step::Zero();
        if (goal_ != MinimaxGoal::Farthest) {
            result.inner = inner;
            result.bound -= distances_.a[inner];
            gradient += distances_.slope(inner);
        }
        if (goal_ != MinimaxGoal::Nearest) {
            result.outer = outer;
            result.bound += distances_.a[outer];
            gradient -= distances_.slope(outer);
        }
        result.normal << -half_ * gradient, 1;
        return result;
    }

    /// A side of the cube or a limit that `step` oversteps; false when there is none.
    bool oversteps(const Step& step, Constraint<N>& found) const
    {
        constexpr double slack = 1e-12;
        double worst = slack;
        for (int axis = 0; axis < N; ++axis)
            if (const double over = std::abs(step[axis]) - 1; over > worst) {
                worst = over;
                found = {};
                found.normal[axis] = step[axis] > 0 ? -1 : 1;
                found.bound = -1;
            }
        for (const Limit<N>& limit : limits_) {
            const double bound = -limit.offset / half_;
            if (const double over = limit.normal.dot(step) + bound; over > worst) {
                worst = over;
                found = {};
                found.normal << -limit.normal, 0;
                found.bound = bound;
                found.limit = true;
            }
        }
        return worst > slack;
    }

private:
    const LinearDistances<N>& distances_;
    MinimaxGoal goal_;
    double half_;
    const std::vector<Limit<N>>& limits_;
};

/// N + 1 constraints and the inverse of the matrix whose rows are their normals.
template <int N>
struct Basis {
    using Vector = Eigen::Vector<double, N + 1>;

    std::array<Constraint<N>, static_cast<std::size_t>(N + 1)> constraints;
    Eigen::Matrix<double, N + 1, N + 1> inverse;

    bool invert()
    {
        Eigen::Matrix<double, N + 1, N + 1> normals;
        for (int k = 0; k <= N; ++k) normals.row(k) = at(k).normal.transpose();
        inverse = normals.inverse();
        return inverse.allFinite();
    }
    Vector point() const
    {
        Vector bounds;
        for (int k = 0; k <= N; ++k) bounds[k] = at(k).bound;
        return inverse * bounds;
    }
    /// Coefficients of `normal` as a combination of the normals of the active constraints.
    Vector weightsOf(const Vector& normal) const { return inverse.transpose() * normal; }
    Vector weights() const { return weightsOf(Vector::Unit(N)).cwiseMax(0); }

    Constraint<N>& at(int k) { return constraints[static_cast<std::size_t>(k)]; }
    const Constraint<N>& at(int k) const { return constraints[static_cast<std::size_t>(k)]; }
};

/// The constraint that has to leave for `normal` to enter: the first whose multiplier falls to zero. -1: none.
template <int N>
int leavingFor(const Basis<N>& basis, const Eigen::Vector<double, N + 1>& normal)
{
    const auto parts = basis.weightsOf(normal).eval();
    const auto weights = basis.weights().eval();
    int leaving = -1;
    double ratio = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= N; ++k) {
        if (!(parts[k] > 1e-11)) continue;
        const double r = weights[k] / parts[k];
        if (r < ratio || (r == ratio && leaving >= 0 && parts[k] > parts[leaving])) {
            ratio = r;
            leaving = k;
        }
    }
    return leaving;
}

}  // namespace

template <int N>
void LinearDistances<N>::clear()
{
    a.clear();
    for (auto& column : u) column.clear();
}

template <int N>
void LinearDistances<N>::push(double distance, const Eigen::Vector<double, N>& slope)
{
    a.push_back(distance);
    for (std::size_t k = 0; k < N; ++k) u[k].push_back(slope[static_cast<int>(k)]);
}

template <int N>
Eigen::Vector<double, N> LinearDistances<N>::slope(std::size_t index) const
{
    Eigen::Vector<double, N> result;
    for (std::size_t k = 0; k < N; ++k) result[static_cast<int>(k)] = u[k][index];
    return result;
}

template <int N>
MinimaxStep<N> minimax(const LinearDistances<N>& distances, MinimaxGoal goal, double half,
                       const std::vector<Limit<N>>& limits, double enough)
{
    using Step = Eigen::Vector<double, N>;
    const Program<N> program(distances, goal, half, limits);
    MinimaxStep<N> result;
    Basis<N> basis;
    // Start at the corner of the cube where the largest piece is smallest.
    basis.at(0) = program.largestPiece(Step::Zero());
    for (int axis = 0; axis < N; ++axis) {
        Constraint<N>& side = basis.at(axis + 1);
        side.normal[axis] = basis.at(0).normal[axis] > 0 ? -1 : 1;
        side.bound = -1;
    }
    basis.invert();
    constexpr int mostExchanges = 300;
    for (int exchange = 0; exchange < mostExchanges; ++exchange) {
        const auto point = basis.point().eval();
        const Step step = point.template head<N>();
        result.value = point[N];
        result.step = half * step;
        if (result.value > enough) break;
        Constraint<N> entering;
        if (!program.oversteps(step, entering)) {
            entering = program.largestPiece(step);
            const double violation = entering.bound - entering.normal.dot(point);
            if (violation <= 2e-16 * (1 + std::abs(entering.bound))) {
                result.solved = true;
                break;
            }
        }
        const int leaving = leavingFor<N>(basis, entering.normal);
        if (leaving < 0) {
            result.feasible = entering.normal[N] != 0;  // a piece of the objective can always be satisfied by a larger
                                                        // value
            break;
        }
        const Constraint<N> left = basis.at(leaving);
        basis.at(leaving) = entering;
        if (!basis.invert()) {
            basis.at(leaving) = left;
            basis.invert();
            break;
        }
    }
    const auto weights = basis.weights().eval();
    for (int k = 0; k <= N; ++k) {
        const Constraint<N>& c = basis.at(k);
        auto& active = result.active[static_cast<std::size_t>(k)];
        active = {c.outer, c.inner, c.limit, weights[k]};
        if (!active.isPiece()) active.weight /= half;
    }
    return result;
}

template struct LinearDistances<2>;
template struct LinearDistances<4>;
template MinimaxStep<2> minimax<2>(const LinearDistances<2>&, MinimaxGoal, double, const std::vector<Limit<2>>&,
                                   double);
template MinimaxStep<4> minimax<4>(const LinearDistances<4>&, MinimaxGoal, double, const std::vector<Limit<4>>&,
                                   double);

}  // namespace lathelier::form
