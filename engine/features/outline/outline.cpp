#include "engine/features/outline/outline.h"

#include <algorithm>
#include <cmath>

#include "engine/features/model/selection.h"
#include "engine/features/model/undercut_search.h"
#include "engine/features/outline/ball_ends.h"
#include "engine/features/outline/outline_limits.h"
#include "engine/features/outline/plane_places.h"
#include "engine/features/outline/stretches.h"
#include "engine/features/outline/wear.h"

namespace lathelier::features {
namespace {

/// Walls of the fine bins that belong to the stretch: near the walls that it was made from.
std::vector<Wall> wallsOf(const OutlineInput& input, const Stretch& stretch)
{
    std::vector<Wall> walls;
    if (stretch.coarse.empty() || stretch.elements.front().rough) return walls;
    for (const Chain& chain : input.fine.chains)
        for (const Wall& wall : chain.walls) {
            if (wall.z_mm < stretch.from_mm - outlineLimits.wall_reach_mm ||
                wall.z_mm > stretch.to_mm + outlineLimits.wall_reach_mm)
                continue;
            const auto over = [&](const Wall& crest) { return std::abs(crest.z_mm - wall.z_mm) < crest.width_mm / 2; };
            if (std::any_of(stretch.crests.begin(), stretch.crests.end(), over)) continue;
            const auto next = std::lower_bound(stretch.coarse.begin(), stretch.coarse.end(), wall.z_mm,
                                               [](const Wall& one, double z) { return one.z_mm < z; });
            const auto near = next == stretch.coarse.end() ? next - 1 : next;
            const auto index = static_cast<std::size_t>(near - stretch.coarse.begin());
            const double slope = std::abs(slopeAt(stretch.coarse, index));
            if (std::abs(wall.r_mm - near->r_mm) <
                outlineLimits.wall_step_mm +
                    outlineLimits.wall_slope_factor * slope * std::abs(wall.z_mm - near->z_mm) +
                    slope * outlineLimits.wall_slope_mm)
                subtractWear(stretch.worn, walls.emplace_back(wall));
        }
    walls.insert(walls.end(), stretch.crests.begin(), stretch.crests.end());
    std::sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.z_mm < b.z_mm; });
    return walls;
}

void makeModel(const OutlineInput& input, const std::vector<Stretch>& stretches, Outline& outline,
               std::vector<Border>& borders)
{
    Model& model = outline.model;
    model.sigma_mm = input.fine.sigma_mm;
    model.spot_mm = outlineLimits.starting_spot_mm;
    const auto plane = [&](double z, double sigma, bool data_end, Border border) {
        Plane made;
        made.z_mm = made.seen_mm = z;
        made.sigma_mm = sigma;
        made.data_end = data_end;
        model.planes.push_back(made);
        borders.push_back(border);
        return model.planes.size() - 1;
    };
    constexpr double end_sigma_mm = outlineLimits.end_sigma_mm;
    std::size_t left = plane(stretches.front().from_mm - input.fine.bin_mm / 2, end_sigma_mm, false, Border::End);
    for (std::size_t s = 0; s < stretches.size(); ++s) {
        const Stretch& stretch = stretches[s];
        Run run;
        run.elements = stretch.elements;
        run.nodes_mm = stretch.nodes_mm;
        run.walls = wallsOf(input, stretch);
        run.left = left;
        if (s + 1 == stretches.size()) {
            run.right = plane(stretch.to_mm + input.fine.bin_mm / 2, end_sigma_mm, false, Border::End);
        } else if (stretch.after == Border::Gap) {
            run.right = plane(stretch.to_mm, end_sigma_mm, true, Border::Gap);
            left = plane(stretches[s + 1].from_mm, end_sigma_mm, true, Border::Gap);
            outline.gaps.push_back({stretch.to_mm, stretches[s + 1].from_mm});
        } else {
            const bool own_rough = stretch.elements.front().rough, next_rough = stretches[s + 1].elements.front().rough;
            const double z = own_rough                           ? stretch.to_mm
                             : next_rough                        ? stretches[s + 1].from_mm
                             : stretch.after == Border::Shoulder ? (stretch.to_mm + stretches[s + 1].from_mm) / 2
                                                                 : stretch.to_mm;
            run.right = left = plane(z, outlineLimits.shoulder_sigma_mm, false, stretch.after);
        }
        model.runs.push_back(std::move(run));
    }
    for (Run& run : model.runs) resolve(model, run);
}

/// A thread or knurl that begins on a cone: the row over its crests begins where the cone reaches them. The uncertainty
/// of that place follows from the cone and the crests, z = at + (crest - level)/slope.
void meetCones(Outline& outline, const std::vector<Border>& borders)
{
    Model& model = outline.model;
    JointFit& fit = outline.fit;
    const auto slotOf = [&](Slot::Of of, std::size_t run, std::size_t element) {
        const auto slot = std::find_if(fit.slots.begin(), fit.slots.end(), [&](const Slot& one) {
            return one.of == of && one.run == run && (of == Slot::Of::Plane || one.element == element);
        });
        return static_cast<Eigen::Index>(slot - fit.slots.begin());
    };
    const auto put = [&](Eigen::Index slot, const Eigen::RowVectorXd& row, double variance) {
        fit.covariance.row(slot) = row;
        fit.covariance.col(slot) = row.transpose();
        fit.covariance(slot, slot) = variance;
    };
    for (std::size_t r = 0; r < model.runs.size(); ++r) {
        const Element& crest = model.runs[r].elements.front();
        if (!crest.rough) continue;
        const Eigen::Index level = slotOf(Slot::Of::Level, r, 0);
        const auto nothing = Eigen::RowVectorXd::Zero(fit.covariance.cols());
        put(level, nothing, crest.level_sigma_mm * crest.level_sigma_mm);
    }
    for (std::size_t r = 0; r + 1 < model.runs.size(); ++r) {
        Run &a = model.runs[r], &b = model.runs[r + 1];
        if (a.right != b.left || borders[a.right] != Border::Lead) continue;
        const bool first_rough = a.elements.back().rough;
        const std::size_t own = first_rough ? r + 1 : r, k = first_rough ? 0 : a.elements.size() - 1;
        const Element& cone = model.runs[own].elements[k];
        const double crest = first_rough ? a.elements.back().level_mm : b.elements.front().level_mm;
        if (cone.arc || std::abs(cone.slope) < outlineLimits.least_cone_slope) continue;
        const double z = cone.at_mm + (crest - cone.level_mm) / cone.slope;
        Plane& plane = model.planes[a.right];
        const bool inside = z > a.nodes_mm[a.nodes_mm.size() - 2] && z < b.nodes_mm[1];
        if (std::abs(z - plane.z_mm) > outlineLimits.cone_reach_mm || !inside) continue;
        plane.z_mm = plane.seen_mm = z;
        const Eigen::MatrixXd& known = fit.covariance;
        const Eigen::Index slope = slotOf(Slot::Of::Slope, own, k), level = slotOf(Slot::Of::Level, own, k);
        const Eigen::Index high = slotOf(Slot::Of::Level, first_rough ? r : r + 1, 0);
        const Eigen::RowVectorXd row =
            (known.row(high) - known.row(level) - (z - cone.at_mm) * known.row(slope)) / cone.slope;
        const double variance = (row[high] - row[level] - (z - cone.at_mm) * row[slope]) / cone.slope;
        plane.sigma_mm = std::sqrt(std::max(outlineLimits.least_cone_variance_mm2, variance));
        put(slotOf(Slot::Of::Plane, a.right, 0), row, plane.sigma_mm * plane.sigma_mm);
        resolve(model, a);
        resolve(model, b);
    }
}

}  // namespace

std::optional<Outline> fitOutline(const OutlineInput& input, const Progress& progress)
{
    Outline outline;
    outline.cuts = input.cuts;
    const std::vector<Stretch> stretches = stretchesOf(input, outline, progress.part(0, 0.1));
    if (stretches.empty()) return std::nullopt;
    std::vector<Border> borders;
    makeModel(input, stretches, outline, borders);
    Model& model = outline.model;
    placePlanes(input, outline, borders, progress);
    fitAll(model, outlineLimits.first_iterations, progress);
    placePlanes(input, outline, borders, progress);
    progress.report(0.3);
    simplify(model, progress);
    selectKinds(model, progress);
    selectKinds(model, progress);
    fitAll(model, outlineLimits.iterations, progress);
    progress.report(0.6);
    tryCorners(model, progress);
    tryUndercuts(model, progress);
    simplify(model, progress);
    selectKinds(model, progress);
    selectKinds(model, progress);
    simplify(model, progress);
    closeBallEnds(input, outline);
    for (const MergedJunction& junction : mergeWithinForm(model, input.form_mm)) outline.merged.push_back(junction);
    // Shared errors decide which elements there are; what they add to the sizes is added to the uncertainty.
    for (Run& run : model.runs)
        for (Wall& wall : run.walls) wall.shared_mm = 0;
    fitAll(model, outlineLimits.iterations, progress);
    placePlanes(input, outline, borders, progress);
    outline.fit = fitAll(model, outlineLimits.last_iterations, progress);
    placePoles(outline);
    meetCones(outline, borders);
    progress.report(1);
    return outline;
}

}  // namespace lathelier::features
