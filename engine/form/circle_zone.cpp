#include "engine/form/circle_zone.h"

#include <algorithm>
#include <cmath>

namespace lathelier {

using Eigen::Vector2d;

ZoneProblem::ZoneProblem(const CirclePoints& points, MinimaxGoal goal, std::vector<HalfPlane> region,
                         const Progress& progress)
    : points_(points), goal_(goal), region_(std::move(region)), progress_(progress)
{
}

void ZoneProblem::seed(const std::array<CirclePoints::Sector, CirclePoints::sectorCount>& sectors)
{
    constexpr std::size_t together = 4;
    for (std::size_t first = 0; first < sectors.size(); first += together) {
        const CirclePoints::Sector *nearest = nullptr, *farthest = nullptr;
        for (std::size_t k = first; k < first + together; ++k) {
            const CirclePoints::Sector& sector = sectors[k];
            if (!sector.occupied) continue;
            if (!nearest || sector.nearest < nearest->nearest) nearest = &sector;
            if (!farthest || sector.farthest > farthest->farthest) farthest = &sector;
        }
        if (!nearest) continue;
        add(nearest->nearest_index);
        if (goal_ == MinimaxGoal::Width) add(farthest->farthest_index);
    }
}

bool ZoneProblem::add(std::size_t index)
{
    if (std::find(working_.begin(), working_.end(), index) != working_.end()) return false;
    working_.push_back(index);
    working_points_.push_back(points_.point(index));
    return true;
}

ZoneProblem::Measured ZoneProblem::measure(const Vector2d& centre)
{
    progress_.check();
    const CirclePoints::Extremes e = points_.extremes(centre);
    bool grew = add(e.nearest_index);
    if (goal_ == MinimaxGoal::Width) grew = add(e.farthest_index) || grew;
    return {goal_ == MinimaxGoal::Width ? e.width() : -e.nearest, e.width(), grew};
}

double ZoneProblem::linearise(const Vector2d& centre)
{
    distances_.clear();
    double smallest = std::numeric_limits<double>::infinity();
    for (const Vector2d& point : working_points_) {
        const Vector2d difference = point - centre;
        const double distance = std::sqrt(difference.squaredNorm());
        smallest = std::min(smallest, distance);
        distances_.push(distance, distance > 0 ? Vector2d(difference / distance) : Vector2d::Zero());
    }
    return smallest;
}

const std::vector<HalfPlane>& ZoneProblem::limitsNear(const Vector2d& centre, double reach)
{
    limits_.clear();
    for (const HalfPlane& edge : region_)
        if (const double room = edge.offset - edge.normal.dot(centre); room < reach)
            limits_.push_back({edge.normal, std::abs(room) < 1e-11 ? 0 : room});  // on the edge but for rounding
    return limits_;
}

ZoneOptimum ZoneProblem::descend(const Vector2d& start)
{
    // Rounding of a distance; an improvement below it is none.
    const double noise = 4e-16 * (1 + start.norm());
    Vector2d centre = start;
    Measured now = measure(centre);
    double half = std::max(4 * now.width, 1e-12);
    MinimaxStep plan;
    constexpr int mostSteps = 200;
    for (int iteration = 0, idle = 0; iteration < mostSteps && idle < 4; ++iteration) {
        linearise(centre);
        plan = minimax(distances_, goal_, half, limitsNear(centre, 1.5 * half));
        const double length = plan.step.lpNorm<Eigen::Infinity>();
        if (!(length > 1e-17)) break;
        const Vector2d trial = centre + plan.step;
        const Measured next = measure(trial);
        if (next.value < now.value) {
            idle = next.value < now.value - noise ? 0 : idle + 1;
            if (length > 0.99 * half) half *= 2;
            centre = trial;
            now = next;
        } else if (!next.grew) {
            // All that matters is in the working set: the tangents reached too far, or nothing is left to gain.
            if (now.value - plan.value <= noise) ++idle;
            half = std::min(half, length) / 4;
            if (half < 1e-16) break;
        }
    }
    ZoneOptimum result;
    result.centre = centre;
    result.value = now.value;
    result.width = now.width;
    linearise(centre);
    plan = minimax(distances_, goal_, std::max(half, 1e-9), limitsNear(centre, 2e-9 + 1.5 * half));
    const auto addTo = [](std::vector<std::size_t>& list, std::size_t index) {
        if (std::find(list.begin(), list.end(), index) == list.end()) list.push_back(index);
    };
    for (const MinimaxStep::Active& active : plan.active) {
        if (!(active.weight > 1e-9)) continue;
        result.held = result.held || active.limit;
        if (active.inner == MinimaxStep::none) continue;
        addTo(result.inner, working_[active.inner]);
        if (active.outer != MinimaxStep::none) addTo(result.outer, working_[active.outer]);
    }
    return result;
}

}  // namespace lathelier
