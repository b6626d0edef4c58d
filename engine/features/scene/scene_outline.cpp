#include "engine/features/scene/scene_outline.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/features/scene/scene_limits.h"

namespace lathelier::features {
namespace {

constexpr std::size_t outlineSectors = 72;
constexpr double notSeen_mm = -std::numeric_limits<double>::infinity();

}  // namespace

SceneOutline::SceneOutline(const std::vector<Eigen::Vector3d>& on_axis, double coverage_deg)
{
    if (on_axis.size() < sceneLimits.least_outline_points) return;
    double last = notSeen_mm, largest = 0;
    first_mm_ = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : on_axis) {
        first_mm_ = std::min(first_mm_, p.z());
        last = std::max(last, p.z());
        largest = std::max(largest, std::hypot(p.x(), p.y()));
    }
    const double length = last - first_mm_;
    step_mm_ = std::max({sceneLimits.least_step_mm, length / sceneLimits.most_steps,
                         length * sceneLimits.points_per_step / static_cast<double>(on_axis.size())});
    const auto steps = static_cast<std::size_t>(length / step_mm_) + 1;
    const double cell_mm = std::max(sceneLimits.least_ring_mm,
                                    largest * static_cast<double>(steps) / static_cast<double>(sceneLimits.most_cells));
    const auto rings = static_cast<std::size_t>(largest / cell_mm) + 2;
    std::vector<std::bitset<outlineSectors>> cells(steps * rings);
    for (const Eigen::Vector3d& p : on_axis) {
        const double turn = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) + 0.5;
        const auto sector = std::min(outlineSectors - 1, static_cast<std::size_t>(turn * outlineSectors));
        const auto step = static_cast<std::size_t>((p.z() - first_mm_) / step_mm_);
        cells[step * rings + static_cast<std::size_t>(std::hypot(p.x(), p.y()) / cell_mm)].set(sector);
    }
    const auto need =
        static_cast<std::size_t>(sceneLimits.least_seen_share * outlineSectors * std::min(1.0, coverage_deg / 360));
    std::vector<double> own(steps, notSeen_mm);
    for (std::size_t s = 0; s < steps; ++s)
        for (std::size_t k = rings - 1; k-- > 0;) {
            const auto& inner = cells[s * rings + k];
            const auto& outer = cells[s * rings + k + 1];
            if ((inner | outer).count() < need) continue;
            own[s] = cell_mm *
                     static_cast<double>(outer.count() > outlineSectors / sceneLimits.outer_ring_part ? k + 2 : k + 1);
            break;
        }
    const auto seen = [](double reach) { return reach > notSeen_mm; };
    const auto from = std::find_if(own.begin(), own.end(), seen);
    if (from == own.end()) return;
    const auto to = std::find_if(own.rbegin(), own.rend(), seen).base();
    first_mm_ += step_mm_ * static_cast<double>(from - own.begin());
    own = {from, to};
    // A stretch not seen all round takes the larger radius of its neighbours.
    for (std::size_t s = 0; s < own.size();) {
        std::size_t next = s;
        while (!seen(own[next])) ++next;
        for (std::size_t gap = s; gap < next; ++gap) own[gap] = std::max(own[s - 1], own[next]);
        s = next + 1;
    }
    reach_mm_ = own;
    for (std::size_t s = 0; s < own.size(); ++s) {
        if (s > 0) reach_mm_[s] = std::max(reach_mm_[s], own[s - 1]);
        if (s + 1 < own.size()) reach_mm_[s] = std::max(reach_mm_[s], own[s + 1]);
    }
}

double SceneOutline::reach_mm(double z_mm) const
{
    if (reach_mm_.empty()) return 0;
    const double last = static_cast<double>(reach_mm_.size() - 1);
    return reach_mm_[static_cast<std::size_t>(std::clamp((z_mm - first_mm_) / step_mm_, 0.0, last))];
}

double SceneOutline::beyond_mm(const Eigen::Vector3d& on_axis) const
{
    if (reach_mm_.empty()) return 0;
    const double last_mm = first_mm_ + step_mm_ * static_cast<double>(reach_mm_.size());
    const double along = std::max({0.0, first_mm_ - on_axis.z(), on_axis.z() - last_mm});
    const double across = std::max(0.0, std::hypot(on_axis.x(), on_axis.y()) - reach_mm(on_axis.z()));
    return std::hypot(along, across);
}

}  // namespace lathelier::features
