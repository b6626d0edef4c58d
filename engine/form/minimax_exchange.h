// The minimax exchange: steps of the linear problem until the objective no longer decreases. Source: Osborne and
// Watson, "An algorithm for minimax approximation in the nonlinear case", Comput. J. 12 (1969) 63-68.
#pragma once

#include <algorithm>

#include "engine/form/linear_minimax.h"

namespace lathelier::form {

template <int N>
struct ExchangeResult {
    Eigen::Vector<double, N> place;  ///< local minimiser of the objective
    double value = 0;                ///< objective at `place`, as measure() returns it
    MinimaxStep<N> plan;             ///< linear problem at `place`: the active constraints
};

/// Local minimum of an objective over N coordinates, started at `start`, to rounding accuracy. `Problem` offers -
/// measure(place): {value on all points, grew: the working set gained a point}; - linearise(place): the working set's
/// distances as LinearDistances<N>; - limitsNear(place, reach): the limits of the place, relative to it; - goal(), and
/// noise(place): the rounding error of a value. Only values measured on all points are accepted; a step without
/// improvement enlarges the working set, or else shortens the next step.
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
            // The working set holds all relevant points: either the step left the range of the linearisation, or the
            // optimum is reached.
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
