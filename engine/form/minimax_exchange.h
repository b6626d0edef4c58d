// The minimax exchange: steps of the linear problem until nothing is left to gain.
// Source: Osborne and Watson, "An algorithm for minimax approximation in the nonlinear case", Comput. J. 12 (1969)
// 63-68.
#pragma once

#include <algorithm>

#include "engine/form/linear_minimax.h"

namespace lathelier::form {

template <int N>
struct ExchangeResult {
    Eigen::Vector<double, N> place;  ///< where the goal has its local minimum
    double value = 0;                ///< of the goal there, as measure() gives it
    MinimaxStep<N> plan;             ///< of the linear problem there: what holds the optimum
};

/// The local minimum of a goal over N coordinates, from `start`, to rounding. `Problem` offers
/// - measure(place): {value on all points, grew: the working set gained a point};
/// - linearise(place): the working set's distances as LinearDistances<N>;
/// - limitsNear(place, reach): the limits of the place, relative to it;
/// - goal(), and noise(place): the rounding of a value.
/// Only values measured on all points are believed; a step that does not improve makes the working set grow, or else
/// the next step shorter.
template <int N, class Problem>
ExchangeResult<N> exchange(Problem& problem, const Eigen::Vector<double, N>& start, double half)
{
    ExchangeResult<N> result;
    result.place = start;
    result.value = problem.measure(start).value;
    const double noise = problem.noise(start);
    constexpr int mostSteps = 200;
    for (int iteration = 0, idle = 0; iteration < mostSteps && idle < 4; ++iteration) {
        const LinearDistances<N>& distances = problem.linearise(result.place);
        const MinimaxStep<N> plan =
            minimax<N>(distances, problem.goal(), half, problem.limitsNear(result.place, 1.5 * half));
        const double length = plan.step.template lpNorm<Eigen::Infinity>();
        if (!plan.feasible || !(length > 1e-17)) break;
        const Eigen::Vector<double, N> trial = result.place + plan.step;
        const auto next = problem.measure(trial);
        if (next.value < result.value) {
            idle = next.value < result.value - noise ? 0 : idle + 1;
            if (length > 0.99 * half) half *= 2;
            result.place = trial;
            result.value = next.value;
        } else if (!next.grew) {
            // All that matters is in the working set: the tangents reached too far, or nothing is left to gain.
            if (result.value - plan.value <= noise) ++idle;
            half = std::min(half, length) / 4;
            if (half < 1e-16) break;
        }
    }
    half = std::max(half, 1e-9);
    const LinearDistances<N>& distances = problem.linearise(result.place);
    result.plan = minimax<N>(distances, problem.goal(), half, problem.limitsNear(result.place, 1.5 * half));
    return result;
}

}  // namespace lathelier::form
