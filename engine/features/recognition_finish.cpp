#include "engine/features/recognition_finish.h"

#include <algorithm>
#include <cmath>

#include "engine/features/features_codes.h"
#include "engine/features/nominal/agreeing_sizes.h"
#include "engine/features/nominal/roles.h"
#include "engine/features/nominal/snap.h"
#include "engine/features/outline/end_closure.h"
#include "engine/features/recognition_limits.h"

namespace lathelier::features {
namespace {

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
    for (std::size_t i = 0; i < result.segments.size(); ++i) {
        std::optional<double>& angle_deg = result.segments[i].uncertainty.angle_deg;
        if (angle_deg > recognitionLimits.unsure_angle_deg) angle_deg.reset();
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
}

}  // namespace

bool isClosed(const RecognizedEnd& end)
{
    return end.closed_by != "data" && end.closed_by != "undecided";
}

void describeEnds(const Outline& outline, Recognition& result)
{
    const Model& model = outline.model;
    const double zero = model.planes.front().z_mm, scale = std::sqrt(result.variance_ratio);
    for (const bool start : {true, false}) {
        const Plane& plane = start ? model.planes.front() : model.planes.back();
        const EndClosure closure = closureOf(outline, start, result.variance_ratio);
        RecognizedEnd end;
        end.z_mm = plane.z_mm - zero;
        end.uncertainty_mm = 2 * scale * plane.sigma_mm;
        end.closed_by = closure.state == EndState::Part   ? closure.shape
                        : closure.state == EndState::Data ? "data"
                                                          : "undecided";
        if (closure.state != EndState::Data) end.span_mm = Interval{closure.from_mm - zero, closure.to_mm - zero};
        const Text name = start ? LT_TEXT("Engine", "free end") : LT_TEXT("Engine", "chuck end");
        if (outline.end_stated[start ? 0 : 1])
            result.notes.push_back({notes::endConfirmed, {{"length_mm", *result.parameters.length_mm}, {"end", name}}});
        else if (closure.state == EndState::Data)
            result.notes.push_back({notes::endNotSeen, {{"end", name}, {"z_mm", end.z_mm}}});
        else if (closure.state == EndState::Undecided)
            result.notes.push_back(
                {notes::endUndecided, {{"end", name}, {"from_mm", end.span_mm->from}, {"to_mm", end.span_mm->to}}});
        result.ends.push_back(end);
    }
    result.length_uncertainty_mm = 2 * scale * std::hypot(model.planes.front().sigma_mm, model.planes.back().sigma_mm);
    if (isClosed(result.ends[0]) && isClosed(result.ends[1]))
        result.length_mm = model.planes.back().z_mm - zero;
    else
        result.complete = false;
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
    result.shaft = result.parameters.snap == Snap::Apply ? agreeingNominal(result, {}).shaft : measuredShaft(result);
}

}  // namespace lathelier::features
