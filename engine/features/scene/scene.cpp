#include "engine/features/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/parallel.h"
#include "engine/features/scene/scene_footprint.h"
#include "engine/features/scene/scene_groups.h"
#include "engine/features/scene/scene_limits.h"
#include "engine/features/scene/scene_outline.h"
#include "engine/features/scene/scene_shapes.h"
#include "engine/features/scene/scene_support.h"
#include "engine/features/scene/scene_thinned.h"
#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;
using registration::RevolutionFit;

enum Kind : std::uint16_t { Part = 0, Turntable = 1, FirstOther = 2 };

std::vector<Vector3d> chosen(const std::vector<Vector3d>& points, const std::vector<std::uint32_t>& indices)
{
    std::vector<Vector3d> some;
    some.reserve(indices.size());
    for (const std::uint32_t i : indices) some.push_back(points[i]);
    return some;
}

/// Decomposition of the scan: turntable, and groups of the remaining points.
class SceneParts {
public:
    SceneParts(const std::vector<Vector3d>& points, const Progress& progress) : points_(points), progress_(progress)
    {
        labels_.assign(points.size(), Part);
        kinds_ = {"part", "turntable"};
    }

    void removeSupport(const SupportPlane& support)
    {
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (std::abs(support.normal.dot(points_[i]) - support.distance_mm) <= support.band_mm)
                labels_[i] = Turntable;
    }

    /// Groups of the remaining points. False: too few points.
    bool group(double extent_mm)
    {
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (labels_[i] == Part) rest_.push_back(static_cast<std::uint32_t>(i));
        if (rest_.size() < sceneLimits.least_part_points) return false;
        restPoints_ = chosen(points_, rest_);
        // Cubes that hold a few points each, so that neighbours on a surface lie in neighbouring cubes.
        double edge_mm = std::max(sceneLimits.least_cube_mm, extent_mm / sceneLimits.group_cubes);
        do {
            thin_ = thinned(restPoints_, edge_mm, progress_);
            edge_mm *= sceneLimits.cube_growth;
        } while (sceneLimits.points_per_cube * thin_.points.size() > restPoints_.size() &&
                 thin_.points.size() > sceneLimits.least_cubes);
        groups_ = groupsOf(thin_.points, sceneLimits.group_gap_cubes * thin_.edge_mm, sceneLimits.least_group_cubes);
        groupOfCube_.assign(thin_.points.size(), -1);
        for (std::size_t g = 0; g < groups_.size(); ++g)
            for (const std::uint32_t cube : groups_[g]) groupOfCube_[cube] = static_cast<int>(g);
        return !groups_.empty();
    }

    /// The part among the groups, its axis, its surface.
    void findPart()
    {
        const std::size_t tried = std::min(groups_.size(), sceneLimits.most_part_candidates);
        for (std::size_t g = 0; g < tried && !turned_; ++g)
            if (sceneLimits.least_candidate_part * groups_[g].size() > groups_[0].size())
                tryAsPart(static_cast<int>(g));
        if (!turned_) part_ = 0;
    }

    void labelRest()
    {
        const int group_count = static_cast<int>(groups_.size());
        std::vector<double> beyond(rest_.size(), 0);
        if (turned_)
            parallelFor(rest_.size(), 32768, progress_, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    beyond[i] = outline_->beyond_mm(fit_.axis_T_scan * restPoints_[i]);
            });
        std::vector<double> own(groups_.size(), 0), all(groups_.size(), 0);
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const int g = groupOf(i);
            if (g < 0) continue;
            all[static_cast<std::size_t>(g)] += 1;
            own[static_cast<std::size_t>(g)] += turned_ && beyond[i] <= sceneLimits.surface_margin_mm;
        }
        std::vector<std::uint16_t> label_of(groups_.size(), Part);
        for (int g = 0; g < group_count; ++g) {
            const auto at = static_cast<std::size_t>(g);
            if (g != part_ && own[at] < sceneLimits.own_point_share * all[at]) label_of[at] = newLabel("clutter");
        }
        std::vector<std::uint32_t> outside;  // of the part's own group
        const std::uint16_t stray = newLabel("clutter");
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const int g = groupOf(i);
            if (g >= 0) labels_[rest_[i]] = label_of[static_cast<std::size_t>(g)];
            if (g < 0 && beyond[i] > sceneLimits.clamp_reach_mm) labels_[rest_[i]] = stray;
            if (g >= 0 && label_of[static_cast<std::size_t>(g)] == Part && beyond[i] > sceneLimits.surface_margin_mm)
                outside.push_back(static_cast<std::uint32_t>(i));
        }
        labelClamps(outside, beyond);
    }

    /// The groups with their boxes, and what is kept.
    Scene scene() const { return sceneOf(points_, labels_, kinds_, turned_ ? "body_of_revolution" : "largest"); }

private:
    int groupOf(std::size_t rest) const { return groupOfCube_[thin_.of_point[rest]]; }

    std::uint16_t newLabel(const char* kind)
    {
        kinds_.emplace_back(kind);
        return static_cast<std::uint16_t>(kinds_.size() - 1);
    }

    /// Fits an axis to the group, repeatedly without the points outside its surface, until it is a body of revolution.
    void tryAsPart(int group)
    {
        std::vector<Vector3d> own;
        for (std::size_t i = 0; i < rest_.size(); ++i)
            if (groupOf(i) == group) own.push_back(restPoints_[i]);
        const std::vector<Vector3d> all = everyNth(restPoints_, sceneLimits.outline_sample);
        std::vector<Vector3d> used = everyNth(own, sceneLimits.fit_sample);
        for (int round = 0; round < sceneLimits.axis_rounds; ++round) {
            progress_.check();
            RevolutionFit fit;
            try {
                fit = registration::fitRevolution(used, progress_);
            } catch (const Error&) {
                return;
            }
            if (fit.iterations == 0) return;
            std::vector<Vector3d> on_axis(all.size());
            for (std::size_t i = 0; i < all.size(); ++i) on_axis[i] = fit.axis_T_scan * all[i];
            SceneOutline outline(on_axis, fit.coverage_deg);
            if (outline.isEmpty()) return;
            if (registration::isBodyOfRevolution(fit)) {
                turned_ = true;
                part_ = group;
                fit_ = fit;
                outline_ = outline;
            }
            std::vector<Vector3d> inside;
            for (const Vector3d& point : own)
                if (outline.beyond_mm(fit.axis_T_scan * point) <= sceneLimits.surface_margin_mm)
                    inside.push_back(point);
            if (inside.size() < sceneLimits.least_part_points) return;
            used = everyNth(inside, sceneLimits.fit_sample);
        }
    }

    /// Labels points far outside the part's surface, down to the contact.
    void labelClamps(const std::vector<std::uint32_t>& outside, const std::vector<double>& beyond)
    {
        const std::vector<Vector3d> points = chosen(restPoints_, outside);
        const Thinned thin = thinned(points, thin_.edge_mm, progress_);
        const auto groups =
            groupsOf(thin.points, sceneLimits.group_gap_cubes * thin_.edge_mm, sceneLimits.least_clamp_cubes);
        std::vector<int> group_of(thin.points.size(), -1);
        for (std::size_t g = 0; g < groups.size(); ++g)
            for (const std::uint32_t cube : groups[g]) group_of[cube] = static_cast<int>(g);
        std::vector<double> reach(groups.size(), 0);
        const auto at = [&](std::size_t i) { return group_of[thin.of_point[i]]; };
        for (std::size_t i = 0; i < outside.size(); ++i)
            if (at(i) >= 0)
                reach[static_cast<std::size_t>(at(i))] =
                    std::max(reach[static_cast<std::size_t>(at(i))], beyond[outside[i]]);
        std::vector<std::uint16_t> label(groups.size(), Part);
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (reach[g] >= sceneLimits.clamp_reach_mm)
                label[g] = newLabel(groups[g].size() >= sceneLimits.least_group_cubes ? "clamp" : "clutter");
        std::map<std::uint16_t, SceneFootprint> footprints;
        for (std::size_t i = 0; i < outside.size(); ++i) {
            const std::uint16_t own = at(i) >= 0 ? label[static_cast<std::size_t>(at(i))] : std::uint16_t{Part};
            labels_[rest_[outside[i]]] = own;
            if (own != Part && beyond[outside[i]] < sceneLimits.contact_margin_mm)
                footprints[own].add(fit_.axis_T_scan * restPoints_[outside[i]]);
        }
        labelContacts(footprints);
    }

    /// Points of the surface about a contact cannot be separated from those of the clamp: they are labelled as clamp.
    void labelContacts(std::map<std::uint16_t, SceneFootprint>& footprints)
    {
        for (auto& labelled : footprints) {
            const std::uint16_t own = labelled.first;
            SceneFootprint& footprint = labelled.second;
            footprint.close();
            parallelFor(rest_.size(), 32768, progress_, [&, own](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    if (labels_[rest_[i]] != Part) continue;
                    const Vector3d p = fit_.axis_T_scan * restPoints_[i];
                    const bool at_surface =
                        std::hypot(p.x(), p.y()) > outline_->reach_mm(p.z()) - sceneLimits.contact_depth_mm;
                    if (at_surface && footprint.contains(p)) labels_[rest_[i]] = own;
                }
            });
        }
    }

    const std::vector<Vector3d>& points_;
    const Progress& progress_;
    std::vector<std::uint16_t> labels_;  ///< index into kinds_, one per point
    std::vector<std::string> kinds_;
    std::vector<std::uint32_t> rest_;  ///< points that are not the turntable's
    std::vector<Vector3d> restPoints_;
    Thinned thin_;                                    ///< of restPoints_
    std::vector<std::vector<std::uint32_t>> groups_;  ///< indices of the cubes of each group
    std::vector<int> groupOfCube_;                    ///< -1: a stray
    int part_ = 0;                                    ///< index into groups_
    bool turned_ = false;
    RevolutionFit fit_;
    std::optional<SceneOutline> outline_;
};

}  // namespace

Scene findScene(const std::vector<Vector3d>& points, SceneUse use, const Progress& progress)
{
    if (use == SceneUse::Keep || points.size() < sceneLimits.least_part_points) return {};
    const double extent_mm = usualExtent_mm(points);
    if (!(extent_mm > 0)) return {};
    const Thinned rough = thinned(everyNth(points, sceneLimits.support_sample),
                                  std::max(sceneLimits.least_cube_mm, extent_mm / sceneLimits.support_cubes), progress);
    const std::optional<SupportPlane> support = findSupport(rough.points, rough.edge_mm);
    if (!support && use == SceneUse::Auto) return {};
    SceneParts parts(points, progress);
    if (support) parts.removeSupport(*support);
    if (!parts.group(extent_mm)) return {};
    progress.report(0.3);
    parts.findPart();
    progress.report(0.8);
    parts.labelRest();
    Scene scene = parts.scene();
    if (!scene.groups.empty()) scene.support = support;
    progress.report(1);
    return scene;
}

const std::vector<QuantityOf<SceneGroup>>& quantitiesOf(const SceneGroup*)
{
    using S = SceneGroup;
    static const auto all =
        describedBy<S>(quantity<S>("kind", &S::kind, {LT_TEXT("Engine", "Kind")}),
                       quantity<S>("points", &S::points, {LT_TEXT("Engine", "Points")}),
                       quantity<S>("kept", &S::kept, {LT_TEXT("Engine", "Kept")}), quantity<S>("reason", &S::reason));
    return all;
}

}  // namespace lathelier::features
