#include "engine/features/refit/refit.h"

#include <algorithm>
#include <cmath>

#include "engine/features/features_codes.h"
#include "engine/features/model/model_limits.h"
#include "engine/features/outline/dimensions.h"
#include "engine/features/recognition_basis.h"
#include "engine/features/recognition_finish.h"
#include "engine/features/refit/model_edit.h"
#include "engine/features/refit/refit_codes.h"
#include "engine/features/refit/refit_limits.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::features {
namespace {

/// A contour has no gaps but those of the data.
void requireContour(const Model& model, double zero_mm)
{
    for (const Run& run : model.runs) {
        bool sound = run.violation < selectionLimits.largest_violation &&
                     std::is_sorted(run.nodes_mm.begin(), run.nodes_mm.end());
        for (std::size_t k = 0; k < run.elements.size(); ++k) {
            const Element& e = run.elements[k];
            for (const double z : {run.nodes_mm[k], run.nodes_mm[k + 1]})
                sound = sound && std::isfinite(e.radiusAt_mm(z)) && e.radiusAt_mm(z) > 0;
        }
        if (!sound) throw Error(errors::rowsDoNotMeet, {{"z_mm", run.nodes_mm.front() - zero_mm}});
    }
}

/// Shifts the results of the earlier fit by the displacement of the free end.
void shift(double by_mm, Recognition& result)
{
    for (auto& bore : result.bores)
        for (RecognizedRow& row : bore) {
            row.z_start_mm += by_mm;
            row.z_end_mm += by_mm;
        }
    for (MergedJunction& junction : result.merged) junction.z_mm += by_mm;
    for (MeridianPoint& point : result.meridian) point.z_mm += by_mm;
    for (ShaftMark& mark : result.marks)
        for (auto* z : {&mark.z_start_mm, &mark.z_end_mm})
            if (*z) **z += by_mm;
    for (UnexplainedStructure& one : result.unexplained) {
        one.z_start_mm += by_mm;
        one.z_end_mm += by_mm;
    }
}

/// Lobes belong to a place: a row has those of the earlier row at its middle.
void keepLobes(const Recognition& found, double shift_mm, std::vector<RecognizedRow>& rows)
{
    for (RecognizedRow& row : rows) {
        const double middle = (row.z_start_mm + row.z_end_mm) / 2 - shift_mm;
        for (const RecognizedRow& before : found.segments)
            if (middle >= before.z_start_mm && middle <= before.z_end_mm) row.lobes = before.lobes;
    }
}

/// What was decided of an end stays, whichever row now leads to it.
void keepEndsSeen(const Recognition& found, Outline& outline)
{
    constexpr double sure = 100;  // ln of odds that nothing outweighs
    for (std::size_t i = 0; i < found.ends.size() && i < 2; ++i) {
        const RecognizedEnd& end = found.ends[i];
        if (outline.end_stated[i] || end.closed_by == "undecided") continue;
        if (!outline.ends[i]) outline.ends[i].emplace();
        outline.ends[i]->log_ratio = isClosed(end) ? sure : -sure;
    }
}

void takeGaps(const Outline& outline, double zero_mm, Recognition& result)
{
    std::erase_if(result.notes, [](const Note& note) {
        for (const NoteCode& code : {notes::gapInData, notes::endConfirmed, notes::endNotSeen, notes::endUndecided})
            if (note.code == code) return true;
        return false;
    });
    result.gaps.clear();
    for (const Gap& gap : outline.gaps) {
        result.gaps.push_back({gap.z_start_mm - zero_mm, gap.z_end_mm - zero_mm});
        result.notes.push_back(
            {notes::gapInData,
             {{"z_start_mm", result.gaps.back().z_start_mm}, {"z_end_mm", result.gaps.back().z_end_mm}}});
    }
    result.complete = result.gaps.empty() && !contains(result.notes, notes::boreNotSeen);
}

}  // namespace

Recognition refit(const Recognition& found, const std::vector<RowChange>& changes, const Progress& progress)
{
    if (changes.empty() || !found.basis) return found;
    const RecognitionBasis& basis = *found.basis;
    Outline outline = basis.outside;
    const double before_mm = outline.model.planes.front().z_mm;
    for (const RowChange& change : changes) {
        progress.check();
        changeStructure(outline, change, before_mm);
    }
    outline.fit = fitAll(outline.model, refitLimits.iterations, progress);
    for (Run& run : outline.model.runs) resolve(outline.model, run);
    const double zero_mm = outline.model.planes.front().z_mm;
    requireContour(outline.model, zero_mm);

    Recognition result = found;
    const Eigen::Isometry3d along(Eigen::Translation3d(0, 0, -zero_mm));
    result.part_T_scan = along * basis.axis_T_scan;
    result.axis_point_mm = result.part_T_scan.inverse().translation();
    shift(before_mm - zero_mm, result);
    result.segments = rowsOf(outline, zero_mm, basis.coverage_deg, basis.added);
    keepLobes(found, before_mm - zero_mm, result.segments);
    std::erase_if(result.meridian, [](const MeridianPoint& point) { return !point.bore; });
    addMeridian(outline, zero_mm, false, 0, result.meridian);
    takeGaps(outline, zero_mm, result);
    result.notes.push_back({notes::rowsChangedByHand, {{"count", static_cast<std::int64_t>(changes.size())}}});
    keepEndsSeen(found, outline);
    result.ends.clear();
    result.length_mm.reset();
    describeEnds(outline, result);
    nameRoughRows(result);
    const Shaft published = found.shaft;
    finishRows(outline, result);
    if (result.parameters.method == RecognitionMethod::Paper) result.shaft = published;
    result.volume_mm3 = result.complete ? std::optional(volume_mm3(result.shaft)) : std::nullopt;
    progress.report(1);
    return result;
}

}  // namespace lathelier::features
