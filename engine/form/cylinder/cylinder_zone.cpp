#include "engine/form/cylinder/cylinder_zone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/form/minimax_exchange.h"

namespace lathelier::form {
namespace {

/// The width of the zone about an axis, on all points or on the working set alone.
class WidthProblem {
public:
    struct Measured {
        double value = 0;
        bool grew = false;
    };

    WidthProblem(const CylinderPoints& points, const Progress& progress) : points_(points), progress_(progress) {}

    void seed(const AxisParameters& axis);
    void useAll(bool all) { all_ = all; }
    std::size_t working(std::size_t index) const { return working_[index]; }

    Measured measure(const AxisParameters& axis)
    {
        progress_.check();
        if (all_) {
            const CylinderPoints::Extremes e = points_.extremes(axis, progress_);
            const bool grew = add(e.nearest_index);
            return {e.width(), add(e.farthest_index) || grew};
        }
        double low = std::numeric_limits<double>::infinity(), high = 0;
        for (const Eigen::Vector3d& point : workingPoints_) {
            const double d = distanceFrom(axis, point).distance;
            low = std::min(low, d);
            high = std::max(high, d);
        }
        return {high - low, false};
    }

    const LinearDistances<4>& linearise(const AxisParameters& axis)
    {
        distances_.clear();
        for (const Eigen::Vector3d& point : workingPoints_) {
            const AxisDistance d = distanceFrom(axis, point);
            distances_.push(d.distance, -d.gradient);
        }
        return distances_;
    }

    const std::vector<Limit<4>>& limitsNear(const AxisParameters&, double) const { return none_; }
    MinimaxGoal goal() const { return MinimaxGoal::Width; }
    double noise(const AxisParameters& axis) const { return 4e-16 * (1 + axis.norm()); }

private:
    bool add(std::size_t index)
    {
        if (std::find(working_.begin(), working_.end(), index) != working_.end()) return false;
        working_.push_back(index);
        workingPoints_.push_back(points_.point(index));
        return true;
    }

    const CylinderPoints& points_;
    Progress progress_;
    bool all_ = true;
    std::vector<std::size_t> working_;
    std::vector<Eigen::Vector3d> workingPoints_;
    LinearDistances<4> distances_;
    std::vector<Limit<4>> none_;
};

/// The extreme points of each patch of the surface: the candidates for contacts.
void WidthProblem::seed(const AxisParameters& axis)
{
    constexpr std::size_t sectors = 16, slabs = 8;
    struct Patch {
        double low = std::numeric_limits<double>::infinity(), high = -1;
        std::size_t low_index = 0, high_index = 0;
    };
    std::vector<Patch> patches(sectors * slabs);
    const double bottom = points_.lowest(), height = points_.highest() - bottom;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (i % 65536 == 0) progress_.check();
        const Eigen::Vector3d p = points_.point(i);
        const double wx = p.x() - axis[0] - p.z() * axis[2], wy = p.y() - axis[1] - p.z() * axis[3];
        const double turn = (std::atan2(wy, wx) / (2 * std::numbers::pi) + 0.5) * double{sectors};
        const std::size_t sector = std::min(static_cast<std::size_t>(turn), sectors - 1);
        const std::size_t slab =
            std::min(static_cast<std::size_t>((p.z() - bottom) / height * double{slabs}), slabs - 1);
        Patch& patch = patches[slab * sectors + sector];
        const double d = wx * wx + wy * wy;
        if (d < patch.low) {
            patch.low = d;
            patch.low_index = i;
        }
        if (d > patch.high) {
            patch.high = d;
            patch.high_index = i;
        }
    }
    for (const Patch& patch : patches) {
        if (patch.high < 0) continue;
        add(patch.low_index);
        add(patch.high_index);
    }
}

}  // namespace

MinimumZoneCylinder minimumZoneCylinder(const CylinderPoints& points, const AxisParameters& start,
                                        const Progress& progress)
{
    WidthProblem problem(points, progress);
    problem.seed(start);
    const double width = problem.measure(start).value, half = std::max(4 * width, 1e-12);
    ExchangeResult<4> best = exchange<4>(problem, start, half);
    // Further starts, up to one zone width away, on the working set: a start without improvement there cannot improve
    // on all points.
    constexpr std::uint64_t otherStarts = 12;
    for (std::uint64_t k = 0; k < otherStarts; ++k) {
        progress.report(0.4 + 0.6 * static_cast<double>(k) / otherStarts);
        AxisParameters from = start;
        for (int c = 0; c < 4; ++c) from[c] += 2 * width * (randomUniform(k, 0, static_cast<std::uint64_t>(c)) - 0.5);
        problem.useAll(false);
        const ExchangeResult<4> promise = exchange<4>(problem, from, half);
        problem.useAll(true);
        if (promise.value >= best.value - problem.noise(start)) continue;
        if (ExchangeResult<4> other = exchange<4>(problem, promise.place, half); other.value < best.value)
            best = std::move(other);
    }

    MinimumZoneCylinder result;
    result.axis = best.place;
    const CylinderPoints::Extremes e = points.extremes(best.place, progress);
    result.inner = e.nearest;
    result.outer = e.farthest;
    for (const MinimaxStep<4>::Active& active : best.plan.active) {
        if (!(active.weight > 1e-9) || !active.isPiece()) continue;
        for (const std::size_t contact : {active.outer, active.inner})
            result.contacts.push_back(problem.working(contact));
    }
    std::sort(result.contacts.begin(), result.contacts.end());
    result.contacts.erase(std::unique(result.contacts.begin(), result.contacts.end()), result.contacts.end());
    return result;
}

}  // namespace lathelier::form
