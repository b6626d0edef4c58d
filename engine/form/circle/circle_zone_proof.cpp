#include <algorithm>
#include <cmath>
#include <queue>

#include "engine/form/circle/circle_zone.h"

namespace lathelier::form {

using Eigen::Vector2d;

/// State of the branch and bound.
struct ZoneProblem::Search {
    ZoneOptimum& best;
    double tolerance;
    std::vector<Vector2d> optima;  ///< centres of the local optima found
    int descents = 0;
    bool unique = true;

    /// Centres nearer than this count as one.
    double separation() const { return std::max({0.01 * best.width, 100 * tolerance, 1e-9}); }
    double threshold() const { return best.value - tolerance; }
};

bool ZoneProblem::isOutside(const Vector2d& centre, double reach) const
{
    return std::any_of(region_.begin(), region_.end(),
                       [&](const HalfPlane& edge) { return edge.normal.dot(centre) - edge.offset > reach; });
}

/// A centre evaluated during the search: a candidate start for a better optimum, or for a second one of equal value.
void ZoneProblem::visit(const Vector2d& centre, const Measured& measured, double curvature, Search& search)
{
    constexpr int mostDescents = 40;
    ZoneOptimum& best = search.best;
    const bool better = measured.value < best.value;
    const bool known = std::any_of(search.optima.begin(), search.optima.end(), [&](const Vector2d& optimum) {
        return (optimum - centre).norm() <= search.separation();
    });
    if (!better &&
        (known || search.descents >= mostDescents || measured.value > best.value + 2 * curvature + search.tolerance))
        return;
    if (better && search.descents >= mostDescents) {
        best.centre = centre;
        best.value = measured.value;
        best.width = measured.width;
        return;
    }
    ++search.descents;
    const ZoneOptimum found = descend(centre);
    const bool apart = (found.centre - best.centre).norm() > search.separation();
    if (found.value < best.value - search.tolerance)
        search.unique = true;
    else if (apart && found.value <= best.value + search.tolerance)
        search.unique = false;
    if (apart) search.optima.push_back(found.centre);
    if (found.value < best.value) best = found;
}

double ZoneProblem::boundOf(const Cell& cell, Search& search)
{
    const double reach = cell.half * std::sqrt(2.0);
    if (isOutside(cell.centre, reach)) return std::numeric_limits<double>::infinity();
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const Vector2d& point : workingPoints_) {
        const double square = (point - cell.centre).squaredNorm();
        low = std::min(low, square);
        high = std::max(high, square);
    }
    double smallest = std::sqrt(low);
    const double largest = std::sqrt(high);
    // A distance changes by no more than the step (Lipschitz).
    double bound = goal_ == MinimaxGoal::Width ? largest - smallest - 2 * reach : -smallest - reach;
    if (bound >= search.threshold() || reach > 0.4 * smallest) return bound;

    for (int round = 0; round < 4; ++round) {
        const std::vector<double>& distances = linearise(cell.centre).a;
        smallest = *std::min_element(distances.begin(), distances.end());
        const double curvature = reach * reach / (2 * (smallest - reach));
        const MinimaxStep<2> plan =
            minimax<2>(distances_, goal_, cell.half, limitsNear(cell.centre, reach), search.threshold() + curvature);
        if (!plan.feasible) return std::numeric_limits<double>::infinity();
        bound = std::max(bound, plan.value - curvature);
        if (bound >= search.threshold() || !plan.solved) break;
        const Vector2d centre = cell.centre + plan.step;
        const std::size_t before = working_.size();
        const Measured measured = measure(centre);
        visit(centre, measured, curvature, search);
        if (working_.size() == before) break;
    }
    return bound;
}

ZoneProof ZoneProblem::prove(ZoneOptimum& best, const Vector2d& middle, double half, double tolerance, int most_nodes)
{
    const auto worse = [](const Cell& a, const Cell& b) { return a.bound > b.bound; };
    std::priority_queue<Cell, std::vector<Cell>, decltype(worse)> cells(worse);
    Search search{best, tolerance, {best.centre}};
    ZoneProof proof;
    double lowest = std::numeric_limits<double>::infinity();  // smallest bound among the discarded cells
    // The grid is shifted off the middle, near which the optimum usually lies, so that the optimum falls into one cell
    // and not between four.
    cells.push({middle + Vector2d(0.137, 0.211) * half, 1.25 * half, -std::numeric_limits<double>::infinity()});
    while (!cells.empty()) {
        const Cell cell = cells.top();
        if (cell.bound >= search.threshold() || proof.nodes >= most_nodes) {
            lowest = std::min(lowest, cell.bound);  // smallest bound of the remaining cells
            break;
        }
        cells.pop();
        progress_.check();
        for (const Vector2d& corner : {Vector2d(-1, -1), Vector2d(1, -1), Vector2d(-1, 1), Vector2d(1, 1)}) {
            Cell child{cell.centre + 0.5 * cell.half * corner, 0.5 * cell.half, cell.bound};
            child.bound = std::max(child.bound, boundOf(child, search));
            ++proof.nodes;
            if (child.bound >= search.threshold())
                lowest = std::min(lowest, child.bound);
            else
                cells.push(child);
        }
    }
    proof.gap = std::max(0.0, best.value - lowest);
    if (goal_ == MinimaxGoal::Width) proof.gap = std::min(proof.gap, best.value);
    proof.unique = search.unique;
    return proof;
}

}  // namespace lathelier::form
