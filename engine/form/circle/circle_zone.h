// Minimum zone and maximum inscribed circle: minimax exchange, and proof by branch and bound.
//
// A distance |p - c| is convex in c, and lies between its tangent and its tangent + |step|² / (2 (distance - |step|)).
// So the optimum of the linear problem over a square, less that term, is a lower bound for all centres in the square;
// the bound is accurate to second order, so that few squares far from the optimum are examined. Both the exchange and
// the proof work on a small set of points that grows by the extreme points of each centre tried: a bound from some of
// the points is a bound for all, and each circle returned has been evaluated on all. Source of branch and bound: Land
// and Doig, Econometrica 28 (1960) 497-520. The bound is derived above.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/progress.h"
#include "engine/form/circle/circle_points.h"
#include "engine/form/minimax_exchange.h"

namespace lathelier::form {

/// A centre with its objective value and its contact points.
struct ZoneOptimum {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of both circles, in the units of CirclePoints
    double value = 0;                                  ///< objective: width, or minus the inner radius
    double width = 0;                                  ///< farthest - nearest
    std::vector<std::size_t> outer;                    ///< contacts of the outer circle
    std::vector<std::size_t> inner;                    ///< contacts of the inner circle, as `outer`
    bool held = false;  ///< true: the region's edge is an active constraint; without it the centre would move on
};

struct ZoneProof {
    double gap = 0;      ///< certified optimality gap: no centre of the region is better by more
    bool unique = true;  ///< false: another centre reaches the same value within the tolerance
    int nodes = 0;       ///< number of squares whose bound was computed
};

class ZoneProblem {
public:
    /// `region` bounds the centre (may be empty).
    ZoneProblem(const CirclePoints& points, MinimaxGoal goal, std::vector<HalfPlane> region, const Progress& progress);

    /// Adds the extreme points of the sectors to the working set.
    void seed(const std::array<CirclePoints::Sector, CirclePoints::sectorCount>& sectors);

    /// Exchange from `start`: the local optimum, to rounding accuracy.
    ZoneOptimum descend(const Eigen::Vector2d& start);

    /// Certifies `best` over the square around `middle`, or finds a better optimum and certifies that.
    ZoneProof prove(ZoneOptimum& best, const Eigen::Vector2d& middle, double half, double tolerance, int most_nodes);

    struct Measured {
        double value = 0;   ///< objective: width, or minus the inner radius
        double width = 0;   ///< farthest - nearest, on all points
        bool grew = false;  ///< the working set gained a point
    };
    // Interface required by exchange().
    Measured measure(const Eigen::Vector2d& centre);  ///< on all points; the working set grows by the extremes
    const LinearDistances<2>& linearise(const Eigen::Vector2d& centre);
    const std::vector<HalfPlane>& limitsNear(const Eigen::Vector2d& centre, double reach);
    MinimaxGoal goal() const { return goal_; }
    double noise(const Eigen::Vector2d& centre) const { return 4e-16 * (1 + centre.norm()); }

private:
    struct Cell {
        Eigen::Vector2d centre;  ///< centre of the square
        double half;             ///< half the side of the square
        double bound;            ///< lower bound of the goal for all centres in the square
    };
    struct Search;

    bool add(std::size_t index);
    bool isOutside(const Eigen::Vector2d& centre, double reach) const;
    double boundOf(const Cell& cell, Search& search);
    void visit(const Eigen::Vector2d& centre, const Measured& measured, double curvature, Search& search);

    const CirclePoints& points_;
    MinimaxGoal goal_;
    std::vector<HalfPlane> region_;
    Progress progress_;
    std::vector<std::size_t> working_;
    std::vector<Eigen::Vector2d> workingPoints_;
    LinearDistances<2> distances_;
    std::vector<HalfPlane> limits_;
};

}  // namespace lathelier::form
