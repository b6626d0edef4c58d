#include "engine/features/part_fit.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/features/features_codes.h"
#include "engine/features/outline/dimensions.h"
#include "engine/features/recognition_limits.h"
#include "engine/features/scene/scene_support.h"
#include "engine/features/structure/bore_proof.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> onAxis(const std::vector<Vector3d>& points, const registration::RevolutionFit& fit,
                             const Progress& progress)
{
    std::vector<Vector3d> moved(points.size());
    parallelFor(points.size(), 32768, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) moved[i] = fit.onAxis(points[i]);
    });
    return moved;
}

/// The end on the turntable lies in its plane; its own points were removed with the plane.
void placeEndOnSupport(const SupportPlane& support, const registration::RevolutionFit& fit, Outline& outline,
                       Notes& notes)
{
    const double first = outline.model.planes.front().z_mm, last = outline.model.planes.back().z_mm;
    if (!endOnSupport(support, fit, outline)) return;
    const double before = first - outline.model.planes.front().z_mm, behind = outline.model.planes.back().z_mm - last;
    const bool free = before != 0;
    notes.push_back({notes::endOnSupport,
                     {{"end", free ? LT_TEXT("Engine", "free end") : LT_TEXT("Engine", "chuck end")},
                      {"moved_mm", free ? before : behind}}});
}

/// Does each wall of the bore lie within the outside? Few points may lead a cone far beyond.
bool liesInside(const Outline& bore, const SurfaceTable& outside)
{
    for (const Run& run : bore.model.runs)
        for (const double z_mm : run.nodes_mm) {
            const double radius_mm = std::abs(radiusAt_mm(run, z_mm));
            const SurfaceTable::Place& place = outside.at(z_mm);
            if (place.run >= 0 && radius_mm >= static_cast<double>(place.radius_mm)) return false;
        }
    return true;
}

PartFit fitOnce(const PartData& data, Walls coarse, Walls fine, const Progress& progress)
{
    OutlineInput input{
        data.points_mm, data.fit, data.meridian.cloud, coarse, fine, data.meridian.scanner, data.form_mm, false, {},
        data.cuts};
    std::optional<Outline> outside = fitOutline(input, progress.part(0, 0.8));
    if (!outside)
        throw Error(errors::tooFewPoints, {{"role", std::string("scan")},
                                           {"points", static_cast<std::int64_t>(data.points_mm.size())},
                                           {"minimum", recognitionLimits.least_points}});
    Notes notes;
    if (data.support) placeEndOnSupport(*data.support, data.fit, *outside, notes);
    SurfaceTable surface(outside->model);
    keepProvenBores(data.meridian.cloud, surface, coarse.sigma_mm, coarse, fine, progress);
    input.bore = true;
    input.part_ends = {outside->model.planes.front(), outside->model.planes.back()};
    std::optional<Outline> bore = fitOutline(input, progress.part(0.8, 1));
    if (bore && !liesInside(*bore, surface)) bore.reset();
    PartFit found{*std::move(outside), std::move(surface), std::move(bore), {}, std::move(notes), data.form_mm};
    found.structure = structureOf(found.seen(data.meridian.cloud), progress);
    return found;
}

std::size_t rowCount(const Outline& outline)
{
    std::size_t count = 0;
    for (const Run& run : outline.model.runs) count += run.elements.size();
    return count;
}

/// Are there rows that correlated noise or differing passes may have made: neighbours of nearly one diameter, or sizes
/// that the data do not determine?
bool hasUnprovenRows(const PartFit& found)
{
    const PartStructure& structure = found.structure;
    if (structure.variance_ratio <= 1 && structure.passes_um <= 0) return false;
    AddedUncertainty added;
    added.variance_ratio = structure.variance_ratio;
    added.passes_um = structure.passes_um;
    const std::vector<RecognizedRow> rows = rowsOf(found.outside, found.zero_mm(), 360, added);
    const auto isUnsure = [](const RecognizedRow& row) {
        const SizeUncertainty& u = row.uncertainty;
        for (const auto& stated_um : {u.z_start_um, u.z_end_um, u.start_diameter_um, u.end_diameter_um})
            if (stated_um.value_or(0) > recognitionLimits.unsure_um) return true;
        return false;
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (isUnsure(rows[i])) return true;
        if (i == 0 || rows[i].kind != RowKind::Cylinder || rows[i - 1].kind != RowKind::Cylinder) continue;
        const double jump_um = 1e3 * std::abs(rows[i].start_diameter_mm - rows[i - 1].end_diameter_mm);
        const double u_um = std::hypot(rows[i].uncertainty.start_diameter_um.value_or(0),
                                       rows[i - 1].uncertainty.end_diameter_um.value_or(0));
        if (jump_um < recognitionLimits.unproven_jump_u * u_um) return true;
    }
    return false;
}

}  // namespace

Meridian meridianOf(const PartPoints& part, const registration::RevolutionFit& fit, const Progress& progress)
{
    const std::vector<Vector3d>& points = part.all();
    Meridian meridian;
    meridian.cloud = meridianCloud(onAxis(points, fit, progress), progress);
    double bin = std::max(recognitionLimits.bin_mm,
                          recognitionLimits.points_per_bin / std::max(1.0, meridian.cloud.points_per_mm));
    meridian.coarse = findWalls(meridian.cloud, bin, fit.sigma_mm, progress);
    if (!part.scan.isMesh())
        meridian.scanner = registration::findScannerAxis(points, fit.axis_T_scan, fit.profile.largestRadius_mm());
    if (!meridian.scanner && bin < recognitionLimits.bin_sigmas * meridian.coarse.sigma_mm) {
        bin = recognitionLimits.bin_sigmas * meridian.coarse.sigma_mm;
        meridian.coarse = findWalls(meridian.cloud, bin, fit.sigma_mm, progress);
    }
    meridian.fine = findWalls(meridian.cloud, bin / 2, fit.sigma_mm, progress);
    return meridian;
}

PartFit fitPart(const PartData& data, const Progress& progress)
{
    PartFit found = fitOnce(data, data.meridian.coarse, data.meridian.fine, progress);
    if (!hasUnprovenRows(found)) return found;
    // Waves that run around the axis count as form in the estimate of the correlation: expanded uncertainties.
    constexpr double k = recognitionLimits.coverage_factor;
    const auto shared = [&](const Walls& walls) {
        return withSharedErrors(walls, k * k * found.structure.variance_ratio, 1e-3 * k * found.structure.passes_um);
    };
    PartFit again = fitOnce(data, shared(data.meridian.coarse), shared(data.meridian.fine), progress.quiet());
    return rowCount(again.outside) < rowCount(found.outside) ? std::move(again) : std::move(found);
}

}  // namespace lathelier::features
