#include "engine/features/outline/plane_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/features/outline/change_point.h"
#include "engine/features/outline/edge_loss.h"
#include "engine/features/outline/end_rows.h"
#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {
namespace {

/// Smallest and largest radius of a run within a distance of one of its planes.
std::pair<double, double> radiiNear(const Run& run, bool start, double reach_mm)
{
    const double from = start ? run.nodes_mm.front() : std::max(run.nodes_mm.front(), run.nodes_mm.back() - reach_mm);
    const double to = start ? std::min(run.nodes_mm.back(), run.nodes_mm.front() + reach_mm) : run.nodes_mm.back();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int k = 0; k <= planeLimits.radius_samples; ++k) {
        const double r = radiusAt_mm(run, from + (to - from) * k / planeLimits.radius_samples);
        low = std::min(low, r);
        high = std::max(high, r);
    }
    return {low, high};
}

/// Radius at which the tangent of an arc beside the plane is across the axis, when it is so near the plane; else
/// nothing. Evaluating the arc at the plane is ill-conditioned there: a small error of the plane gives a large one of
/// the radius.
std::optional<double> uprightAt(const Element& element, const Plane& plane, double side)
{
    if (!element.arc) return std::nullopt;
    const double upright = element.centre_z_mm + side * element.radius_mm();
    return std::abs(upright - plane.z_mm) < planeLimits.upright_reach_mm ? std::optional(element.centre_r_mm)
                                                                         : std::nullopt;
}

void move(Plane& plane, double z_mm, double sigma_mm)
{
    plane.z_mm = plane.seen_mm = z_mm;
    plane.sigma_mm = sigma_mm;
}

double firstLength_mm(const Run& run)
{
    return run.nodes_mm[1] - run.nodes_mm.front();
}

double lastLength_mm(const Run& run)
{
    return run.nodes_mm.back() - run.nodes_mm[run.nodes_mm.size() - 2];
}

/// A small step of the radius. The log-likelihood ratio of a point is clipped at ±4.6 (100 : 1), against spurious
/// points.
void placeStep(const OutlineInput& input, Model& model, std::size_t p, const Run& a, const Run& b)
{
    constexpr double largest = planeLimits.largest_log_ratio;
    Plane& plane = model.planes[p];
    const Element &before = a.elements.back(), &after = b.elements.front();
    const double jump = startRadius_mm(b) - endRadius_mm(a), sigma = model.sigma_mm;
    const double reach = std::min({planeLimits.step_reach_mm, planeLimits.step_reach_share * lastLength_mm(a),
                                   planeLimits.step_reach_share * firstLength_mm(b)});
    if (jump == 0 || !(sigma > 0)) return;
    std::vector<LogLikelihoodRatio> points;
    for (std::size_t i = 0; i < input.cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(input.cloud.z_mm[i]);
        if (std::abs(z - plane.z_mm) > reach) continue;
        const double low = before.radiusAt_mm(z), high = after.radiusAt_mm(z);
        const double off = static_cast<double>(input.cloud.r_mm[i]) - (low + high) / 2;
        if (std::abs(off) > std::abs(high - low) / 2 + planeLimits.far_sigmas * sigma) continue;
        points.push_back({z, std::clamp(off * (high - low) / (sigma * sigma), -largest, largest)});
    }
    const auto place = placeOfChange(std::move(points), plane.z_mm - reach, plane.z_mm + reach, model.spot_mm);
    if (place) move(plane, place->z_mm, place->sigma_mm);
}

/// The end of a thread or a knurl beside a wall that its grooves nearly reach: the density of the radii on the rough
/// zone is the histogram of all of its points.
void placeRoughEnd(const OutlineInput& input, Model& model, std::size_t p, const Run& a, const Run& b)
{
    constexpr double largest = planeLimits.largest_log_ratio;
    const bool first_rough = a.elements.back().rough;
    const Run& rough = first_rough ? a : b;
    const Element& wall = first_rough ? b.elements.front() : a.elements.back();
    const double sigma = model.sigma_mm;
    if (wall.arc || wall.rough || std::abs(wall.slope) > planeLimits.steepest_rough_wall || !(sigma > 0)) return;
    Plane& plane = model.planes[p];
    const double own = first_rough ? firstLength_mm(b) : lastLength_mm(a);
    const double length = rough.nodes_mm.back() - rough.nodes_mm.front();
    const double reach = std::min(
        {planeLimits.rough_reach_mm, planeLimits.step_reach_share * own, planeLimits.rough_reach_share * length});
    const double far = planeLimits.far_sigmas * sigma, step = planeLimits.rough_bin_sigmas * sigma;
    const double low = std::min(wall.level_mm, rough.elements.front().root_mm) - far,
                 high = std::max(wall.level_mm, rough.elements.front().level_mm) + far;
    std::vector<double> counts(static_cast<std::size_t>((high - low) / step) + 1, planeLimits.rough_prior);
    double all = 0;
    std::vector<std::pair<double, double>> near;
    for (std::size_t i = 0; i < input.cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(input.cloud.z_mm[i]), r = static_cast<double>(input.cloud.r_mm[i]);
        if (!(r > low && r < high)) continue;
        if (std::abs(z - plane.z_mm) < reach) near.emplace_back(z, r);
        if (z < rough.nodes_mm.front() + planeLimits.rough_margin_mm ||
            z > rough.nodes_mm.back() - planeLimits.rough_margin_mm)
            continue;
        counts[static_cast<std::size_t>((r - low) / step)] += 1;
        all += 1;
    }
    if (all < planeLimits.least_rough_points) return;
    std::vector<LogLikelihoodRatio> points;
    for (const auto& [z, r] : near) {
        const double u = (r - wall.radiusAt_mm(z)) / sigma;
        const double on_wall = -u * u / 2 - std::log(sigma * std::sqrt(2 * std::numbers::pi));
        const double on_rough = std::log(counts[static_cast<std::size_t>((r - low) / step)] / (all * step));
        const double log_ratio = std::clamp(on_wall - on_rough, -largest, largest);
        points.push_back({z, first_rough ? log_ratio : -log_ratio});
    }
    const auto place = placeOfChange(std::move(points), plane.z_mm - reach, plane.z_mm + reach, model.spot_mm);
    if (place) move(plane, place->z_mm, place->sigma_mm);
}

/// The radii of two runs at the plane between them.
struct LevelsAtPlane {
    double before_mm = 0, after_mm = 0;
    double lag_mm = 0;   ///< distance behind the plane at which the rays show its edge
    bool rises = false;  ///< the larger radius lies behind the plane

    double step_mm() const { return std::abs(after_mm - before_mm); }
};

LevelsAtPlane levelsAt(const Run& a, const Run& b, const Plane& plane, double sigma_mm)
{
    const Element &before = a.elements.back(), &after = b.elements.front();
    const auto upright_before = uprightAt(before, plane, 1), upright_after = uprightAt(after, plane, -1);
    LevelsAtPlane levels;
    levels.before_mm = before.rough                      ? before.root_mm
                       : upright_before && before.convex ? *upright_before
                                                         : endRadius_mm(a);
    levels.after_mm = after.rough ? after.root_mm : upright_after && after.convex ? *upright_after : startRadius_mm(b);
    const bool rises = levels.rises = levels.after_mm > levels.before_mm;
    double &low = rises ? levels.before_mm : levels.after_mm, &high = rises ? levels.after_mm : levels.before_mm;
    // A hollow that falls across the axis from the larger radius counts as that radius until it is deep enough.
    const Element& fall = rises ? before : after;
    const auto& upright = rises ? upright_before : upright_after;
    if (!upright || fall.convex || !(*upright > high - planeLimits.hollow_margin_mm)) return levels;
    const double most = fall.radius_mm(), depth = std::min(planeLimits.hollow_depth_sigmas * sigma_mm, most / 2);
    low = high - std::min(2 * depth, most);
    levels.lag_mm = (rises ? -1 : 1) * (most - std::sqrt(most * most - depth * depth));
    return levels;
}

/// Places the planes of one outline.
class PlanePlacing {
public:
    PlanePlacing(const OutlineInput& input, Outline& outline) : input_(input), outline_(outline), model_(outline.model)
    {
        double walls = 0, area = 0;
        for (const Run& run : model_.runs)
            for (const Wall& wall : run.walls) {
                walls += wall.points;
                area += 2 * std::numbers::pi * wall.r_mm * input.fine.bin_mm;
            }
        density_per_mm2_ = area > 0 ? walls / area : 0;
        if (const auto& scanner = input.scanner)
            lean_ = std::hypot(scanner->direction.x(), scanner->direction.y()) / std::abs(scanner->direction.z());
    }

    /// The plane between run r and the next: a step, a face, or an edge for placeByRays().
    void placeBetween(std::size_t r, Border border)
    {
        const Run &a = model_.runs[r], &b = model_.runs[r + 1];
        Plane& plane = model_.planes[a.right];
        const bool is_rough = a.elements.back().rough || b.elements.front().rough;
        const double least_mm = planeLimits.least_shoulder_sigmas * model_.sigma_mm;
        if (border == Border::Lead) return;
        if (border == Border::Step || (border == Border::Shoulder && !is_rough && stepBetween(a, b, plane) < least_mm))
            return placeStep(input_, model_, a.right, a, b);
        const LevelsAtPlane levels = levelsAt(a, b, plane, model_.sigma_mm);
        plane.lean = lean_ * levels.step_mm();
        plane.low_side = levels.rises ? -1 : 1;
        plane.is_clear = false;
        if (is_rough && levels.step_mm() < least_mm) return placeRoughEnd(input_, model_, a.right, a, b);
        if (!placeByFace(plane, std::min(levels.before_mm, levels.after_mm),
                         std::max(levels.before_mm, levels.after_mm)))
            addEdge(a, b, plane, levels);
    }

    /// Edges whose faces are not seen, from hits and misses of the rays.
    void placeByRays(const Progress& progress)
    {
        if (edges_.empty() || input_.bore) return;
        const double clear_mm = clusterGap_mm(model_.sigma_mm) + planeLimits.clear_sigmas * model_.sigma_mm;
        std::vector<double> spots;
        const auto rays = registration::findEdgeRays(input_.points_mm, input_.fit, edges_, progress);
        outline_.unsure_edges_mm.clear();
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const auto place = placeOf(rays[e]);
            if (!place) continue;
            const EdgeOfPlane& edge = edgesOfPlanes_[e];
            Plane& plane = model_.planes[edge.plane];
            // The widest spot is a bound: the rays of a scanner hit and miss over all of it, and say nothing of the
            // edge.
            if (input_.scanner && place->spot_mm >= edgeLimits.widths_mm.back()) {
                outline_.unsure_edges_mm.push_back(plane.z_mm);
                continue;
            }
            move(plane, place->z_mm - edge.lag_mm, place->sigma_mm);
            plane.is_clear = edge.lag_mm == 0 && edge.step_mm > clear_mm;
            spots.push_back(place->spot_mm);
        }
        if (!spots.empty()) model_.spot_mm = upperMedianInPlace(spots);
    }

    void placeEnd(bool start)
    {
        const Run& run = start ? model_.runs.front() : model_.runs.back();
        Plane& plane = model_.planes[start ? run.left : run.right];
        if (plane.pole) return;
        const double radius = start ? startRadius_mm(run) : endRadius_mm(run);
        const auto part_end = std::find_if(input_.part_ends.begin(), input_.part_ends.end(), [&](const Plane& end) {
            return std::abs(end.z_mm - plane.z_mm) < planeLimits.part_end_mm;
        });
        if (part_end != input_.part_ends.end())
            return move(plane, part_end->z_mm, std::max(planeLimits.part_end_floor_mm, part_end->sigma_mm));
        const std::size_t index = start ? 0 : 1;
        // Rays across the axis see no face, and what lies between the crests of a thread is none.
        const bool is_strict = input_.scanner || run.elements.front().rough;
        const double sparser = is_strict ? edgeLimits.least_face_density : edgeLimits.least_end_face_density;
        if (input_.bore) {
            ++sought_;
        } else if (placeByFace(plane, planeLimits.end_face_share * radius, radius, sparser)) {
            outline_.face_seen[index] = true;
            return;
        }
        auto& found = outline_.ends[index] = std::nullopt;
        if (input_.scanner && !input_.bore) found = endInRows(input_.cloud, model_, start, *input_.scanner);
        // Hits that end before the walls do are not all the hits.
        if (found && wallsBeyond_mm(run, start, found->place.z_mm) > edgeLimits.most_walls_beyond_mm) found.reset();
        if (!found && !run.elements.front().rough) found = endOf(input_.cloud, model_, run, start, lossAtEnds_mm());
        if (found) move(plane, found->place.z_mm, found->place.sigma_mm);
    }

    /// A scan that shows most faces sees no edges: walls beside them do not count.
    void decideKindOfScan()
    {
        outline_.surface_scan = !input_.scanner && faces_ > 0 && 2 * faces_ >= sought_;
        if (!outline_.surface_scan && (!input_.bore || input_.scanner)) return;
        model_.corner_mm = model_.edge_mm = planeLimits.surface_corner_mm;
        model_.spot_mm = 0;
    }

private:
    struct EdgeOfPlane {
        std::size_t plane = 0;
        double lag_mm = 0, step_mm = 0;
    };

    /// Step of the radius; for hollows that are upright at the plane, where it is not defined, a large one.
    double stepBetween(const Run& a, const Run& b, const Plane& plane) const
    {
        const Element &before = a.elements.back(), &after = b.elements.front();
        const bool hollow =
            (!before.convex && uprightAt(before, plane, 1)) || (!after.convex && uprightAt(after, plane, -1));
        return hollow ? planeLimits.hollow_margin_mm + planeLimits.least_shoulder_sigmas * model_.sigma_mm
                      : std::abs(startRadius_mm(b) - endRadius_mm(a));
    }

    /// How far the walls go on beyond a place of the end.
    static double wallsBeyond_mm(const Run& run, bool start, double z_mm)
    {
        if (run.walls.empty()) return 0;
        return start ? z_mm - run.walls.front().z_mm : run.walls.back().z_mm - z_mm;
    }

    /// Without rows of rays a scan may lose points beside edges whose faces it does not see.
    double lossAtEnds_mm() const
    {
        if (input_.scanner || input_.bore) return 0;
        const double spacing = density_per_mm2_ > 0 ? 1 / std::sqrt(density_per_mm2_) : 0;
        return std::max(lossAtEdges_mm(input_.cloud, model_), spacing / 2);
    }

    bool placeByFace(Plane& plane, double inner_mm, double outer_mm, double sparser = edgeLimits.least_face_density)
    {
        ++sought_;
        const auto face =
            seenFace(input_.cloud, plane.z_mm, inner_mm, outer_mm, model_.sigma_mm, density_per_mm2_ / sparser);
        if (!face) return false;
        move(plane, face->z_mm, face->sigma_mm);
        ++faces_;
        return true;
    }

    void addEdge(const Run& a, const Run& b, const Plane& plane, const LevelsAtPlane& levels)
    {
        const double room_mm =
            std::min({planeLimits.room_mm, planeLimits.room_share * (a.nodes_mm.back() - a.nodes_mm.front()),
                      planeLimits.room_share * (b.nodes_mm.back() - b.nodes_mm.front())});
        const auto [a_low, a_high] = radiiNear(a, false, room_mm);
        const auto [b_low, b_high] = radiiNear(b, true, room_mm);
        const bool rises = levels.rises;
        registration::Edge edge;
        edge.z_mm = plane.z_mm;
        edge.sign = rises ? 1 : -1;
        edge.before_mm = rises ? a_low : levels.before_mm;
        edge.after_mm = rises ? levels.after_mm : b_low;
        edge.above_mm = std::max(0.0, rises ? b_high - levels.after_mm : a_high - levels.before_mm);
        edge.from_mm = plane.z_mm - room_mm;
        edge.to_mm = plane.z_mm + room_mm;
        if (std::abs(edge.after_mm - edge.before_mm) < planeLimits.least_ray_step_sigmas * model_.sigma_mm) return;
        edges_.push_back(edge);
        edgesOfPlanes_.push_back({a.right, levels.lag_mm, levels.step_mm()});
    }

    const OutlineInput& input_;
    Outline& outline_;
    Model& model_;
    double density_per_mm2_ = 0;  ///< of the points on the walls
    double lean_ = 0;             ///< tangent of the angle between the rays and the planes
    int faces_ = 0, sought_ = 0;
    std::vector<registration::Edge> edges_;
    std::vector<EdgeOfPlane> edgesOfPlanes_;  ///< of the same order
};

}  // namespace

void placePlanes(const OutlineInput& input, Outline& outline, const std::vector<Border>& borders,
                 const Progress& progress)
{
    PlanePlacing placing(input, outline);
    std::vector<Run>& runs = outline.model.runs;
    for (std::size_t r = 0; r + 1 < runs.size(); ++r)
        if (runs[r].right == runs[r + 1].left) placing.placeBetween(r, borders[runs[r].right]);
    placing.placeByRays(progress);
    for (const bool start : {true, false}) placing.placeEnd(start);
    placing.decideKindOfScan();
    for (Run& run : runs) resolve(outline.model, run);
}

}  // namespace lathelier::features
