// The smallest largest value of linear functions over a square of the plane: one step of a minimax fit.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

namespace lathelier {

/// normal · c ≤ offset, the normal of length one.
struct HalfPlane {
    Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
    double offset = 0;
};

/// Distances of points from a centre, linear in its step: a - u · step.
struct LinearDistances {
    std::vector<double> a, ux, uy;

    std::size_t size() const { return a.size(); }
    void clear();
    void push(double distance, const Eigen::Vector2d& direction);
};

enum class MinimaxGoal {
    Width,   ///< the largest distance minus the smallest
    Nearest  ///< minus the smallest distance
};

struct MinimaxStep {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    /// A constraint that holds the solution, with its multiplier: a pair of distances (Width), one distance (Nearest),
    /// a limit, or none of these: a side of the square.
    struct Active {
        std::size_t outer = none, inner = none;
        bool limit = false;
        double weight = 0;
    };

    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    double value = 0;      ///< of the goal at the step; if not `solved`, a lower bound of it
    bool solved = false;   ///< false: stopped above `enough`, or lost in rounding
    bool feasible = true;  ///< false: the limits leave nothing of the square
    std::array<Active, 3> active;
};

/// Minimises the goal over |step| ≤ half in both coordinates and within the limits, by a dual exchange of three
/// active constraints whose value only grows: it may stop as soon as it is above `enough`.
MinimaxStep minimax(const LinearDistances& distances, MinimaxGoal goal, double half,
                    const std::vector<HalfPlane>& limits = {}, double enough = std::numeric_limits<double>::infinity());

}  // namespace lathelier
