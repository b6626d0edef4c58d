#include "engine/features/recognition_finish.h"

#include <algorithm>
#include <cmath>

#include "engine/features/features_codes.h"
#include "engine/features/nominal/agreeing_sizes.h"
#include "engine/features/nominal/roles.h"
#include "engine/features/nominal/snap.h"
#include "engine/features/recognition_limits.h"

namespace lathelier::features {
namespace {

/// Kind of closure of an end of the outside (RecognizedEnd::closed_by).
std::string closedBy(const std::vector<RecognizedRow>& rows, bool start)
{
    const RecognizedRow& row = start ? rows.front() : rows.back();
    const double toward_end = start ? row.half_angle_deg : -row.half_angle_deg;
    if (row.kind == RowKind::Arc) return *row.arc_radius_mm > 0 ? "round" : "edge";
    return row.kind == RowKind::Cone && toward_end > recognitionLimits.chamfer_half_angle_deg ? "chamfer" : "edge";
}

/// Is the end of the data an end of the part? Unknown counts as no, unless it follows a chamfer or a round.
bool isPartEnd(const Outline& outline, bool start, const std::string& closed_by)
{
    const Plane& plane = start ? outline.model.planes.front() : outline.model.planes.back();
    const auto is_any = [&](bool (Cut::*holds)(double) const) {
        return std::any_of(outline.cuts.begin(), outline.cuts.end(),
                           [&](const Cut& cut) { return (cut.*holds)(plane.z_mm); });
    };
    if (is_any(&Cut::isAtLimit)) return false;
    if (outline.balls[start ? 0 : 1]) return true;
    if (outline.face_seen[start ? 0 : 1]) return true;
    // Between jaws the last of the part may be hidden in all directions.
    if (is_any(&Cut::contains)) return false;
    const auto& end = outline.ends[start ? 0 : 1];
    if (!end) return closed_by != "edge";
    if (end->tilt_share_sigma < recognitionLimits.tilt_share_sigma)
        return end->tilt_share < recognitionLimits.tilt_share;
    return closed_by != "edge";
}

/// Sizes whose U is larger than any size of interest are stated without it, with a note.
void dropUndetermined(Recognition& result)
{
    using U = SizeUncertainty;
    static constexpr std::pair<std::optional<double> U::*, Text> sizes[]{
        {&U::z_start_um, LT_TEXT("Engine", "start")},
        {&U::z_end_um, LT_TEXT("Engine", "end")},
        {&U::length_um, LT_TEXT("Engine", "length")},
        {&U::start_diameter_um, LT_TEXT("Engine", "start diameter")},
        {&U::end_diameter_um, LT_TEXT("Engine", "end diameter")},
        {&U::arc_radius_um, LT_TEXT("Engine", "radius")}};
    for (std::size_t i = 0; i < result.segments.size(); ++i)
        for (const auto& [member, name] : sizes) {
            std::optional<double>& stated_um = result.segments[i].uncertainty.*member;
            double most_um = recognitionLimits.unsure_um;
            if (member == &U::arc_radius_um)
                most_um = std::max(most_um, 1e3 * recognitionLimits.unsure_radius_share *
                                                std::abs(result.segments[i].arc_radius_mm.value_or(0)));
            if (!stated_um || *stated_um <= most_um) continue;
            result.notes.push_back(
                {notes::sizeNotDetermined,
                 {{"row", static_cast<std::int64_t>(i) + 1}, {"size", name}, {"uncertainty_mm", 1e-3 * *stated_um}}});
            stated_um.reset();
        }
}

}  // namespace

void describeEnds(const Outline& outline, Recognition& result)
{
    const Model& model = outline.model;
    const double zero = model.planes.front().z_mm, scale = std::sqrt(result.variance_ratio);
    bool seen[2];
    for (const bool start : {true, false}) {
        const Plane& plane = start ? model.planes.front() : model.planes.back();
        RecognizedEnd end;
        end.z_mm = plane.z_mm - zero;
        end.uncertainty_mm = 2 * scale * plane.sigma_mm;
        end.closed_by = outline.face_seen[start ? 0 : 1] ? "face" : closedBy(result.segments, start);
        seen[start ? 0 : 1] = isPartEnd(outline, start, end.closed_by);
        if (!seen[start ? 0 : 1]) end.closed_by = "data";
        result.ends.push_back(end);
    }
    const double measured = model.planes.back().z_mm - zero;
    result.length_uncertainty_mm = 2 * scale * std::hypot(model.planes.front().sigma_mm, model.planes.back().sigma_mm);
    if (seen[0] && seen[1]) result.length_mm = measured;
    for (const bool start : {true, false}) {
        if (seen[start ? 0 : 1]) continue;
        const Text end = start ? LT_TEXT("Engine", "free end") : LT_TEXT("Engine", "chuck end");
        if (result.parameters.length_mm)
            result.notes.push_back({notes::endConfirmed, {{"length_mm", *result.parameters.length_mm}, {"end", end}}});
        else
            result.notes.push_back({notes::endNotSeen, {{"end", end}, {"z_mm", result.ends[start ? 0 : 1].z_mm}}});
    }
    if (!result.length_mm && result.parameters.length_mm) {
        result.length_mm = result.parameters.length_mm;
        // The unseen end is placed by the stated length.
        const double missing = *result.parameters.length_mm - measured;
        if (!seen[1] && !result.segments.empty()) {
            result.segments.back().z_end_mm += missing;
            result.ends[1].z_mm += missing;
        } else if (!seen[0] && !result.segments.empty()) {
            for (RecognizedRow& row : result.segments) {
                row.z_start_mm += missing;
                row.z_end_mm += missing;
            }
            result.segments.front().z_start_mm = 0;
            for (RecognizedEnd& end : result.ends) end.z_mm += &end == &result.ends[1] ? missing : 0;
        }
    }
    if (!result.length_mm) result.complete = false;
}

void nameRoughRows(Recognition& result)
{
    for (const ShaftMark& mark : result.marks)
        for (RecognizedRow& row : result.segments) {
            const double middle = (*mark.z_start_mm + *mark.z_end_mm) / 2;
            if (row.role != "rough" || middle < row.z_start_mm || middle > row.z_end_mm) continue;
            row.role = key(mark);
            if (mark.kind == MarkKind::Knurl) row.start_diameter_mm = row.end_diameter_mm = *mark.diameter_mm;
        }
    for (RecognizedRow& row : result.segments)
        if (row.role == "rough") row.role.clear();
}

void finishRows(const Outline& outline, Recognition& result)
{
    dropUndetermined(result);
    double squares = 0, n = 0, covered = 0;
    for (const MeridianPoint& point : result.meridian)
        if (!std::isnan(point.residual_mm)) {
            squares += point.residual_mm * point.residual_mm;
            n += 1;
        }
    result.residual_rmse_mm = n > 0 ? std::sqrt(squares / n) : 0;
    result.chi2_per_bin = outline.fit.rows > 0 ? outline.fit.chi2 / static_cast<double>(outline.fit.rows) : 0;
    for (const RecognizedRow& row : result.segments) covered += row.z_end_mm - row.z_start_mm;
    const double whole = result.ends.back().z_mm - result.ends.front().z_mm;
    result.coverage_percent = whole > 0 ? 100 * covered / whole : 0;
    std::stable_sort(result.meridian.begin(), result.meridian.end(),
                     [](const MeridianPoint& a, const MeridianPoint& b) { return a.z_mm < b.z_mm; });
    describeRows(result);
    result.shaft =
        result.parameters.snap == Snap::Apply ? agreeingNominal(result, {}).shaft : measuredShaft(result);
}

}  // namespace lathelier::features
