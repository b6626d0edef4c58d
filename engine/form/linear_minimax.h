// Minimises the maximum of linear functions over an N-dimensional cube: one step of a minimax fit. Source: exchange of
// Stiefel, Numer. Math. 1 (1959) 1-28, as a dual method.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

namespace lathelier::form {

/// normal · step ≤ offset, the normal of length one.
template <int N>
struct Limit {
    Eigen::Vector<double, N> normal = Eigen::Vector<double, N>::Zero();  ///< unit vector pointing out of the feasible
                                                                         ///< half space
    double offset = 0;  ///< distance from the step 0 to the limit; < 0: the step 0 violates it
};
using HalfPlane = Limit<2>;

/// Distances of points from a circle's centre or an axis, linear in its step: a - u · step.
template <int N>
struct LinearDistances {
    std::vector<double> a;  ///< distance of each point at the step 0
    std::array<std::vector<double>, static_cast<std::size_t>(N)>
        u;  ///< [coordinate][point]: negative gradient of the distance

    std::size_t size() const { return a.size(); }
    void clear();
    void push(double distance, const Eigen::Vector<double, N>& slope);
    Eigen::Vector<double, N> slope(std::size_t index) const;
};

enum class MinimaxGoal {
    Width,    ///< the largest distance minus the smallest
    Nearest,  ///< minus the smallest distance
    Farthest  ///< the largest distance
};

template <int N>
struct MinimaxStep {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    /// A constraint active at the solution, with its multiplier: the largest or the smallest distance or both, as the
    /// objective requires; a limit; otherwise a side of the cube.
    struct Active {
        std::size_t outer = none, inner = none;  ///< indices of the points of this piece; `none`: no such point
        bool limit = false;                      ///< true: one of the limits
        double weight = 0;                       ///< Lagrange multiplier, ≥ 0

        bool isPiece() const { return outer != none || inner != none; }
    };

    Eigen::Vector<double, N> step = Eigen::Vector<double, N>::Zero();  ///< the best step, or where the search stopped
    double value = 0;      ///< objective at the step; if not `solved`, a lower bound of the minimum
    bool solved = false;   ///< false: stopped above `enough`, or no further progress within rounding
    bool feasible = true;  ///< false: no point of the cube satisfies the limits
    std::array<Active, static_cast<std::size_t>(N + 1)> active;  ///< constraints active at the solution
};

/// Minimises the objective over |step| ≤ half in every coordinate and within the limits, by a dual exchange of N + 1
/// active constraints. The dual value increases monotonically, so the search may stop once it exceeds `enough`. For N =
/// 2 and 4.
template <int N>
MinimaxStep<N> minimax(const LinearDistances<N>& distances, MinimaxGoal goal, double half,
                       const std::vector<Limit<N>>& limits = {},
                       double enough = std::numeric_limits<double>::infinity());

}  // namespace lathelier::form
