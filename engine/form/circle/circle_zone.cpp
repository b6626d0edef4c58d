#include "engine/form/circle/circle_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::form {

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
    workingPoints_.push_back(points_.point(index));
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

const LinearDistances<2>& ZoneProblem::linearise(const Vector2d& centre)
{
    distances_.clear();
    for (const Vector2d& point : workingPoints_) {
        const Vector2d difference = point - centre;
        const double distance = std::sqrt(difference.squaredNorm());
        distances_.push(distance, distance > 0 ? Vector2d(difference / distance) : Vector2d::Zero());
    }
    return distances_;
}

const std::vector<HalfPlane>& ZoneProblem::limitsNear(const Vector2d& centre, double reach)
{
    limits_.clear();
    for (const HalfPlane& edge : region_)
        if (const double room = edge.offset - edge.normal.dot(centre); room < reach)
            limits_.push_back({edge.normal, std::abs(room) < 1e-11 ? 0 : room});  // on the edge within rounding
    return limits_;
}

ZoneOptimum ZoneProblem::descend(const Vector2d& start)
{
    const double half = std::max(4 * measure(start).width, 1e-12);
    const ExchangeResult<2> found = exchange<2>(*this, start, half);
    ZoneOptimum result;
    result.centre = found.place;
    result.value = found.value;
    result.width = points_.extremes(found.place).width();
    const auto addTo = [](std::vector<std::size_t>& list, std::size_t index) {
        if (std::find(list.begin(), list.end(), index) == list.end()) list.push_back(index);
    };
    for (const MinimaxStep<2>::Active& active : found.plan.active) {
        if (!(active.weight > 1e-9)) continue;
        result.held = result.held || active.limit;
        if (active.inner != MinimaxStep<2>::none) addTo(result.inner, working_[active.inner]);
        if (active.outer != MinimaxStep<2>::none) addTo(result.outer, working_[active.outer]);
    }
    // The last step may stop, as sufficient, before all active constraints are known.
    constexpr std::size_t generic = 4;  // contacts of a minimum zone
    if (goal_ == MinimaxGoal::Width && !result.held && result.outer.size() + result.inner.size() < generic) {
        const CirclePoints::Extremes e = points_.extremes(found.place);
        const double same = 1e-9 * e.width() + 8 * std::numeric_limits<double>::epsilon() * e.farthest;
        for (const std::size_t index : working_) {
            const double distance = (points_.point(index) - found.place).norm();
            if (e.farthest - distance <= same) addTo(result.outer, index);
            if (distance - e.nearest <= same) addTo(result.inner, index);
        }
    }
    return result;
}

}  // namespace lathelier::form
