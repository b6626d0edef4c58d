#include "engine/features/structure/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/features/features_codes.h"
#include "engine/features/report/recognition_quantities.h"
#include "engine/features/structure/face_map.h"
#include "engine/features/structure/lobes.h"
#include "engine/features/structure/noise_correlation.h"
#include "engine/features/structure/unexplained.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::features {
namespace {

constexpr double largestChiSquare = 2;   ///< per bin: more is not chance
constexpr double leastOffset_mm = 0.01;  ///< of a row from the axis, recognition.md section 5

/// Calls for every row of the model: run, element.
template <class F>
void forEachRow(const Model& model, const F& call)
{
    for (std::size_t r = 0; r < model.runs.size(); ++r)
        for (std::size_t k = 0; k < model.runs[r].elements.size(); ++k) call(r, k);
}

void noteStructure(const UnexplainedStructure& one, Notes& notes)
{
    Values values{{"z_start_mm", one.z_start_mm}, {"z_end_mm", one.z_end_mm}, {"area_mm2", one.area_mm2}};
    values.emplace_back("places", one.places);
    values.emplace_back("found", fmt::format("{} z {:.1f}-{:.1f}", key(one.kind), one.z_start_mm, one.z_end_mm));
    if (one.kind == StructureKind::NoPoints) {
        notes.push_back({notes::unexplainedHole, std::move(values)});
        return;
    }
    values.emplace_back("structure", structureName(one.kind));
    values.emplace_back("height_mm", one.height_mm.value_or(0));
    notes.push_back({notes::unexplainedStructure, std::move(values)});
}

/// Rows off the axis: a note, and beyond the form tolerance a structure, for the table has them on it.
void addEccentricRows(double form_mm, Recognition& result)
{
    if (contains(result.notes, notes::partIsBent)) return;
    for (std::size_t i = 0; i < result.segments.size(); ++i) {
        const RecognizedRow& row = result.segments[i];
        if (row.lobes.offset_mm.value_or(0) <= leastOffset_mm) continue;
        result.notes.push_back({notes::segmentNotCoaxial,
                                {{"row", static_cast<std::int64_t>(i) + 1},
                                 {"z_start_mm", row.z_start_mm},
                                 {"z_end_mm", row.z_end_mm},
                                 {"offset_mm", *row.lobes.offset_mm}}});
        if (*row.lobes.offset_mm <= form_mm) continue;
        UnexplainedStructure found;
        found.kind = StructureKind::Eccentric;
        found.z_start_mm = row.z_start_mm;
        found.z_end_mm = row.z_end_mm;
        found.area_mm2 = std::numbers::pi * row.start_diameter_mm * (row.z_end_mm - row.z_start_mm);
        found.height_mm = row.lobes.offset_mm;
        found.angle_deg = row.lobes.offset_deg;
        result.unexplained.push_back(found);
    }
}

/// The ends of a rough row are not those of a face that is seen all round: their places are stated without uncertainty.
void withdrawEdges(Recognition& result)
{
    std::vector<RecognizedRow>& rows = result.segments;
    const auto isSpoilt = [&](const RecognizedRow& row) {
        return std::any_of(result.unexplained.begin(), result.unexplained.end(), [&](const UnexplainedStructure& one) {
            const double shared = std::min(row.z_end_mm, one.z_end_mm) - std::max(row.z_start_mm, one.z_start_mm);
            return one.kind == StructureKind::Rough && 2 * shared > row.z_end_mm - row.z_start_mm;
        });
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!isSpoilt(rows[i])) continue;
        SizeUncertainty& own = rows[i].uncertainty;
        own.z_start_um.reset();
        own.z_end_um.reset();
        own.length_um.reset();
        if (i > 0) rows[i - 1].uncertainty.z_end_um.reset();
        if (i > 0) rows[i - 1].uncertainty.length_um.reset();
        if (i + 1 < rows.size()) rows[i + 1].uncertainty.z_start_um.reset();
        if (i + 1 < rows.size()) rows[i + 1].uncertainty.length_um.reset();
        result.notes.push_back({notes::endsOfStructure, {{"row", static_cast<std::int64_t>(i) + 1}}});
    }
}

double chiSquarePerBin(const JointFit& fit)
{
    return fit.rows > 0 ? fit.chi2 / static_cast<double>(fit.rows) : 0;
}

void noteLobes(Recognition& result)
{
    std::int64_t count = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < result.segments.size(); ++i) {
        const RowLobes& lobes = result.segments[i].lobes;
        if (!lobes.lobes) continue;
        if (count == 0 || *lobes.height_um > *result.segments[worst].lobes.height_um) worst = i;
        ++count;
    }
    if (count == 0) return;
    const RowLobes& lobes = result.segments[worst].lobes;
    result.notes.push_back({notes::rowsNotRound,
                            {{"count", count},
                             {"row", static_cast<std::int64_t>(worst) + 1},
                             {"lobes", *lobes.lobes},
                             {"height_um", *lobes.height_um}}});
}

void noteNoise(const PartStructure& structure, const JointFit& fit, Recognition& result)
{
    result.passes_differ_um = structure.passes_um;
    const double chi2 = chiSquarePerBin(fit);
    if (structure.by_scatter)
        result.notes.push_back({notes::scatterUnexplained, {{"chi2", chi2}}});
    else if (structure.variance_ratio > 1)
        result.notes.push_back({notes::scanNoiseCorrelated, {{"factor", std::sqrt(structure.variance_ratio)}}});
    if (structure.passes_um > 0)
        result.notes.push_back({notes::passesDiffer, {{"difference_um", 2 * structure.passes_um}, {"chi2", chi2}}});
}

}  // namespace

PartStructure structureOf(const StructureInput& input, const Progress& progress)
{
    const Model& model = input.outside.model;
    PartStructure found;
    found.map = residualMap(input.cloud, input.surface, model, input.bore, progress);
    found.passes_um = differenceOfPasses_um(input.outside);
    // Lobes of form are no correlation of the noise; what is sure of them follows from that of the rest.
    ResidualMap rest = found.map;
    forEachRow(model, [&](std::size_t r, std::size_t k) {
        progress.check();
        if (model.runs[r].elements[k].rough) return;
        const LobeFit fit = lobesOf(found.map, input.surface, model.runs[r], k, 1, lobeThresholds.lobe_share);
        removeLobes(rest, input.surface, r, k, fit.curve_mm);
    });
    found.variance_ratio = varianceRatio(rest, input.surface, model);
    found.passes_um = std::max(found.passes_um, differenceOfOrder_um(found.map, found.variance_ratio));
    const double chi2 = chiSquarePerBin(input.outside.fit);
    if (chi2 > largestChiSquare && chi2 > found.variance_ratio && found.passes_um == 0) {
        found.variance_ratio = chi2;
        found.by_scatter = true;
    }
    const double scale = std::sqrt(found.variance_ratio);
    forEachRow(model, [&](std::size_t r, std::size_t k) {
        progress.check();
        found.lobes.emplace_back();
        if (model.runs[r].elements[k].rough) return;
        const LobeFit fit = lobesOf(found.map, input.surface, model.runs[r], k, scale);
        found.lobes.back() = fit.lobes;
        removeLobes(found.map, input.surface, r, k, fit.curve_mm);
    });
    return found;
}

void describeStructure(const StructureInput& input, const PartStructure& structure, double zero_mm, Recognition& result,
                       const Progress& progress)
{
    for (std::size_t i = 0; i < std::min(result.segments.size(), structure.lobes.size()); ++i)
        result.segments[i].lobes = structure.lobes[i];
    for (const double z : input.outside.unsure_edges_mm)
        result.notes.push_back({notes::edgeNotPlaced, {{"z_mm", z - zero_mm}}});
    noteNoise(structure, input.outside.fit, result);
    noteLobes(result);
    std::vector<ShaftMark> marks = result.marks;
    for (ShaftMark& mark : marks) {
        *mark.z_start_mm += zero_mm;
        *mark.z_end_mm += zero_mm;
    }
    result.unexplained =
        unexplainedOutside(structure.map, input.surface, input.outside, marks, input.form_mm, progress);
    const std::vector<UnexplainedStructure> faces =
        holesInFaces(seenFaces(input.cloud, input.outside, input.bore, progress), marks);
    result.unexplained.insert(result.unexplained.end(), faces.begin(), faces.end());
    for (UnexplainedStructure& one : result.unexplained) {
        one.z_start_mm -= zero_mm;
        one.z_end_mm -= zero_mm;
    }
    addEccentricRows(input.form_mm, result);
    std::stable_sort(
        result.unexplained.begin(), result.unexplained.end(),
        [](const UnexplainedStructure& a, const UnexplainedStructure& b) { return a.z_start_mm < b.z_start_mm; });
    if (result.unexplained.empty()) return;
    withdrawEdges(result);
    if (result.parameters.unexplained == Unexplained::Damage)
        result.notes.push_back(
            {notes::takenForDamage, {{"count", static_cast<std::int64_t>(result.unexplained.size())}}});
    else
        for (const UnexplainedStructure& one : result.unexplained) noteStructure(one, result.notes);
}

}  // namespace lathelier::features
