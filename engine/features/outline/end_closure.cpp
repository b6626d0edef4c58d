#include "engine/features/outline/end_closure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/core/units.h"
#include "engine/features/features_codes.h"
#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {
namespace {

/// What the last element says: its shape, and ln of the ratio of its probabilities at an end of the part and where
/// data happen to end.
struct EndShape {
    const char* name = "edge";
    double log_ratio = 0;
};

/// Distance of the rows of points near an end: that of the larger gaps between walls, since a row that leans is
/// several.
double rowPitch_mm(const Run& run, bool start)
{
    const std::size_t n = run.walls.size(), count = std::min(closureLimits.walls_for_pitch, n);
    std::vector<double> z;
    for (std::size_t i = 0; i < count; ++i) z.push_back(start ? run.walls[i].z_mm : -run.walls[n - 1 - i].z_mm);
    double largest = 0, pitch = 0;
    for (std::size_t i = 0; i + 1 < count; ++i) largest = std::max(largest, z[i + 1] - z[i]);
    std::optional<double> before;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (z[i + 1] - z[i] < closureLimits.gap_share * largest) continue;
        if (before) pitch = std::max(pitch, z[i] - *before);
        before = z[i];
    }
    return std::max(largest, pitch);
}

/// A short chamfer or round is where most parts end, and where few of all places along a part lie.
EndShape shapeAt(const Model& model, bool start)
{
    const Run& run = start ? model.runs.front() : model.runs.back();
    const Element& e = start ? run.elements.front() : run.elements.back();
    if (e.rough) return {};
    const std::size_t last = run.nodes_mm.size() - 1;
    const double end = start ? run.nodes_mm.front() : run.nodes_mm.back(),
                 inner = start ? run.nodes_mm[1] : run.nodes_mm[last - 1];
    const double along = std::abs(end - inner), whole = model.planes.back().z_mm - model.planes.front().z_mm;
    const double drop = e.radiusAt_mm(inner) - e.radiusAt_mm(end);
    EndShape shape;
    if (e.arc) {
        if (!e.convex) return shape;
        shape.name = "round";
        // A quarter circle, or what reaches the axis; a part of one may go on.
        const double upright = e.centre_z_mm + (start ? -1 : 1) * e.radius_mm();
        const double missing = std::abs(upright - end) / e.radius_mm();
        if (missing > closureLimits.missing_round_share && e.radiusAt_mm(end) > closureLimits.at_axis_mm) return shape;
    } else {
        const double half_angle_deg = std::atan2(drop, along) * deg_per_rad;
        if (half_angle_deg < closureLimits.chamfer_half_angle_deg) return shape;
        shape.name = "chamfer";
    }
    // One row of points may be one of any shape.
    if (along < closureLimits.least_rows * rowPitch_mm(run, start)) return shape;
    const double least = std::max(closureLimits.least_drop_mm, closureLimits.least_drop_sigmas * model.sigma_mm);
    if (drop < least || along < closureLimits.least_length_mm) return shape;
    shape.log_ratio = std::max(0.0, std::log(closureLimits.shaped_ends * whole / along));
    return shape;
}

}  // namespace

EndClosure closureOf(const Outline& outline, bool start, double variance_ratio)
{
    const std::size_t index = start ? 0 : 1;
    const Plane& plane = start ? outline.model.planes.front() : outline.model.planes.back();
    const EndShape shape = shapeAt(outline.model, start);
    const double expanded_mm = 2 * std::sqrt(variance_ratio) * plane.sigma_mm;
    EndClosure found;
    const bool is_ball = outline.balls[index].has_value();
    found.shape = is_ball ? "round" : outline.face_seen[index] ? "face" : shape.name;
    found.is_whole = shape.log_ratio >= closureLimits.decisive;
    found.from_mm = plane.z_mm - expanded_mm;
    found.to_mm = plane.z_mm + expanded_mm;
    const auto is_any = [&](bool (Cut::*holds)(double) const) {
        return std::any_of(outline.cuts.begin(), outline.cuts.end(),
                           [&](const Cut& cut) { return (cut.*holds)(plane.z_mm); });
    };
    const auto& end = outline.ends[index];
    const bool at_limit = is_any(&Cut::isAtLimit);
    if (outline.end_stated[index] || (!at_limit && (is_ball || outline.face_seen[index]))) {
        found.state = EndState::Part;
    } else if (at_limit || is_any(&Cut::contains)) {
        // Between jaws the last of the part may be hidden in all directions.
        found.state = EndState::Data;
    } else {
        const double evidence = closureLimits.whole_scans + shape.log_ratio + (end ? end->log_ratio : 0);
        if (evidence >= closureLimits.decisive)
            found.state = EndState::Part;
        else if (evidence <= -closureLimits.decisive)
            found.state = EndState::Data;
        if (found.state != EndState::Undecided) return found;
        if (end) {
            found.from_mm = std::min(end->from_mm, plane.z_mm);
            found.to_mm = std::max(end->to_mm, plane.z_mm);
        }
        // Where no ray passed the end it may lie anywhere up to the next row.
        const double pitch_mm = rowPitch_mm(start ? outline.model.runs.front() : outline.model.runs.back(), start);
        if (start)
            found.from_mm = std::min(found.from_mm, found.to_mm - pitch_mm);
        else
            found.to_mm = std::max(found.to_mm, found.from_mm + pitch_mm);
    }
    return found;
}

void applyStatedLength(double length_mm, double variance_ratio, Outline& outline)
{
    Model& model = outline.model;
    Plane* const planes[]{&model.planes.front(), &model.planes.back()};
    const double measured = planes[1]->z_mm - planes[0]->z_mm;
    const EndClosure closures[]{closureOf(outline, true, variance_ratio), closureOf(outline, false, variance_ratio)};
    double shorter = 0, longer = 0;
    for (const std::size_t i : {0U, 1U}) {
        const double inward = i == 0 ? closures[i].to_mm - planes[i]->z_mm : planes[i]->z_mm - closures[i].from_mm;
        const double outward = i == 0 ? planes[i]->z_mm - closures[i].from_mm : closures[i].to_mm - planes[i]->z_mm;
        shorter = std::hypot(shorter, inward);
        longer = std::hypot(longer, outward);
    }
    const double missing = length_mm - measured;
    const auto refuse = [&] {
        return Error(errors::lengthAgainstData,
                     {{"length_mm", length_mm}, {"data_mm", measured}, {"uncertainty_mm", std::max(shorter, longer)}});
    };
    const double reading = closureLimits.reading_mm;
    if (missing < -shorter - reading) throw refuse();
    const bool agrees = missing <= longer + reading;
    // The data's end first, then one that is not decided; of two, the chuck's.
    std::optional<std::size_t> moved;
    for (const EndState state : {EndState::Data, EndState::Undecided})
        for (const std::size_t i : {1U, 0U}) {
            const bool goes_on = agrees || !closures[i].is_whole;
            if (!moved && closures[i].state == state && goes_on) moved = i;
        }
    if (!moved) {
        if (agrees) return;
        throw refuse();
    }
    Run& run = *moved == 0 ? model.runs.front() : model.runs.back();
    const Element& last = *moved == 0 ? run.elements.front() : run.elements.back();
    if (last.arc && !agrees) throw refuse();
    if (!last.arc) {
        Plane& plane = *planes[*moved];
        plane.z_mm += *moved == 0 ? -missing : missing;
        plane.seen_mm = plane.z_mm;
        resolve(model, run);
        if (!(last.radiusAt_mm(plane.z_mm) > 0) || run.violation > 0) throw refuse();
    }
    for (const std::size_t i : {0U, 1U}) outline.end_stated[i] = closures[i].state != EndState::Part;
}

}  // namespace lathelier::features
