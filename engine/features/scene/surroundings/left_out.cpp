#include "engine/features/scene/surroundings/left_out.h"

#include <algorithm>
#include <limits>

#include "engine/features/scene/scene_groups.h"
#include "engine/features/scene/surroundings/surroundings.h"
#include "engine/features/scene/surroundings/surroundings_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double beyondData_mm = 1e5;  // in place of infinity

/// The zones on the axis of `fit`. `before`: as they were placed on an axis that the excluded points may have
/// deflected; its first data and its sense along the axis are kept.
ZonesOnAxis zonesOn(const registration::RevolutionFit& fit, const Walls& walls, const RecognitionParameters& parameters,
                    const std::optional<ZonesOnAxis>& before)
{
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const Chain& chain : walls.chains) {
        first = std::min(first, chain.zFirst_mm() - walls.bin_mm / 2);
        last = std::max(last, chain.zLast_mm() + walls.bin_mm / 2);
    }
    if (!(first <= last)) first = last = 0;
    if (!before)
        return {Isometry3d(Eigen::Translation3d(0, 0, -first)) * fit.axis_T_scan,
                {parameters.exclude_z_mm, last - first}};
    const Isometry3d scan_T_zones = before->zones_T_scan.inverse();
    const bool turned = (fit.axis_T_scan.linear() * scan_T_zones.linear().col(2)).z() < 0;
    const Isometry3d axis_T_scan = turned ? registration::reversed(fit).axis_T_scan : fit.axis_T_scan;
    const double zero = (axis_T_scan * scan_T_zones.translation()).z();
    return {Isometry3d(Eigen::Translation3d(0, 0, -zero)) * axis_T_scan, before->zones};
}

}  // namespace

LeftOut leftOutFirst(const std::vector<Vector3d>& points, const RecognitionParameters& parameters,
                     const Progress& progress)
{
    LeftOut first;
    first.scene = findScene(points, parameters.scene == SceneUse::Keep ? SceneUse::Keep : SceneUse::Auto, progress);
    return first;
}

std::optional<LeftOut> leftOutWithoutAxis(const LeftOut& now, const std::vector<Vector3d>& points,
                                          const RecognitionParameters& parameters, const Progress& progress)
{
    // Between the jaws of a chuck the part is seen in too few directions to be told from a clamp.
    const bool has_holder = !now.scene.hidden.empty();
    if (parameters.scene != SceneUse::Cut || now.is_cut || now.zones || has_holder) return std::nullopt;
    const Scene found = findScene(points, SceneUse::Cut, progress);
    if (found.groups.empty()) return std::nullopt;
    LeftOut next = now;
    next.scene = joined(now.scene, found);
    next.is_cut = true;
    next.searches = 0;
    return next;
}

std::optional<LeftOut> leftOutNext(const LeftOut& now, const UsedPoints& used, const RecognitionParameters& parameters,
                                   const Progress& progress)
{
    LeftOut next = now;
    if (parameters.scene != SceneUse::Keep && now.searches < surroundingsLimits.most_searches && !now.zones) {
        const Scene found = findSurroundings(used.points, used.fit, used.cloud, used.walls, progress);
        next.searches = found.groups.empty() ? surroundingsLimits.most_searches : now.searches + 1;
        if (!found.groups.empty()) {
            next.scene = joined(now.scene, found);
            return next;
        }
    }
    if (auto cut = leftOutWithoutAxis(now, used.points, parameters, progress)) return cut;
    if (parameters.exclude_z_mm.empty() || now.placings == surroundingsLimits.most_placings) return std::nullopt;
    next.zones = zonesOn(used.fit, used.walls, parameters, now.zones);
    ++next.placings;
    return next;
}

std::vector<std::uint8_t> keptPoints(const LeftOut& left_out, const std::vector<Vector3d>& points,
                                     std::int64_t& excluded)
{
    excluded = 0;
    std::vector<std::uint8_t> kept = left_out.scene.kept;
    if (!left_out.zones) return kept;
    if (kept.empty()) kept.assign(points.size(), 1);
    const Eigen::RowVector3d along = left_out.zones->zones_T_scan.linear().row(2);
    const double offset = left_out.zones->zones_T_scan.translation().z();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!kept[i] || !left_out.zones->zones.contains(along * points[i] + offset)) continue;
        kept[i] = 0;
        ++excluded;
    }
    return kept;
}

std::vector<Cut> cutsOf(const LeftOut& left_out, const registration::RevolutionFit& fit)
{
    std::vector<HiddenStretch> stretches = left_out.scene.hidden;
    if (left_out.zones) {
        const Isometry3d scan_T_zones = left_out.zones->zones_T_scan.inverse();
        const auto at = [&](double z) {
            return scan_T_zones * Vector3d(0, 0, std::clamp(z, -beyondData_mm, beyondData_mm));
        };
        for (const Interval& zone : left_out.zones->zones.zones_mm())
            stretches.push_back({at(zone.from), at(zone.to), surroundingsLimits.zone_reach_mm});
    }
    std::vector<Cut> cuts;
    for (const HiddenStretch& stretch : stretches) {
        const double a = (fit.axis_T_scan * stretch.from_mm).z(), b = (fit.axis_T_scan * stretch.to_mm).z();
        cuts.push_back({std::min(a, b), std::max(a, b), stretch.reach_mm});
    }
    return cuts;
}

void endChainsAt(const std::vector<Cut>& cuts, Walls& walls)
{
    if (cuts.empty()) return;
    std::vector<Chain> ended;
    for (const Chain& chain : walls.chains) {
        Chain part{{}, chain.bore};
        for (const Wall& wall : chain.walls) {
            const auto is_between = [&](const Cut& cut) {
                return cut.liesBetween(part.walls.back().z_mm, wall.z_mm, walls.bin_mm);
            };
            if (!part.walls.empty() && std::any_of(cuts.begin(), cuts.end(), is_between)) {
                ended.push_back(part);
                part.walls.clear();
            }
            part.walls.push_back(wall);
        }
        ended.push_back(std::move(part));
    }
    std::erase_if(ended, [](const Chain& chain) { return chain.walls.size() < surroundingsLimits.least_walls; });
    walls.chains = std::move(ended);
}

}  // namespace lathelier::features
