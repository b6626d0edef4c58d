#include "engine/features/recognition.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/features/features_codes.h"
#include "engine/features/holes/bolt_circles.h"
#include "engine/features/holes/cross_holes.h"
#include "engine/features/marks/marks.h"
#include "engine/features/nominal/snap.h"
#include "engine/features/outline/ball_ends.h"
#include "engine/features/outline/dimensions.h"
#include "engine/features/outline/end_closure.h"
#include "engine/features/outline/outline.h"
#include "engine/features/paper_method.h"
#include "engine/features/part_fit.h"
#include "engine/features/part_points.h"
#include "engine/features/recognition_basis.h"
#include "engine/features/recognition_finish.h"
#include "engine/features/recognition_limits.h"
#include "engine/features/scene/surroundings/left_out.h"
#include "engine/features/seen_bores.h"
#include "engine/features/stretches/rounding.h"
#include "engine/features/structure/structure.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution_refusal.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;
using registration::RevolutionFit;

RevolutionFit fitAxis(const std::vector<Vector3d>& points, FreeEnd free_end, const Progress& progress)
{
    RevolutionFit fit = registration::fitRevolution(points, progress);
    registration::orientAxis(fit);
    if (free_end == FreeEnd::Last) fit = registration::reversed(fit);
    return fit;
}

/// Stretches that were made round, in the frame of the fit without them.
struct MadeRound {
    std::vector<ShaftMark> marks;
    std::vector<UnsureEnd> unsure_ends;
};

/// Makes stretches round that are not. Nothing changes where there are none.
MadeRound makeRound(PartPoints& part, FreeEnd free_end, RevolutionFit& fit, Meridian& meridian,
                    const Progress& progress)
{
    const double sigma_mm = meridian.coarse.sigma_mm;
    const std::vector<NotRoundStretch> stretches = notRoundStretches(meridian.cloud, sigma_mm, fit, progress);
    if (stretches.empty()) return {};
    part.own = madeRound(part.all(), fit, stretches, sigma_mm, progress);
    part.is_cut = true;
    const RevolutionFit before = fit;
    fit = fitAxis(part.own, free_end, progress.quiet());
    meridian = meridianOf(part, fit, progress.quiet());
    MadeRound made{marksIn(fit, before, stretches), unsureEndsIn(fit, before, stretches)};
    shareForm(made.marks, meridian.coarse);
    shareForm(made.marks, meridian.fine);
    return made;
}

/// Do most points lie on surfaces of revolution about the axis? Then the others may be named: an eccentric, a square.
bool isMostlyTurned(const RevolutionFit& fit)
{
    return fit.not_turned == registration::NotTurned::NotRound && fit.converged &&
           fit.consistent_share >= recognitionLimits.mostly_turned_share;
}

/// Notes about the fit, or its refusal.
void judgeAxis(const RevolutionFit& fit, Notes& notes)
{
    registration::remarkRevolution(fit, "scan", notes);
    if (!registration::isBodyOfRevolution(fit) && !isMostlyTurned(fit)) registration::refuseRevolution(fit, "scan");
}

/// May points that are not the part's be the reason that this is no body of revolution?
bool mayBeSpoilt(const RevolutionFit& fit, const RecognitionParameters& parameters)
{
    const bool may_leave_out = parameters.scene != SceneUse::Keep || !parameters.exclude_z_mm.empty();
    const bool has_axis =
        fit.not_turned == registration::NotTurned::NotRound || fit.not_turned == registration::NotTurned::SeveralParts;
    return may_leave_out && has_axis && fit.iterations > 0 && fit.coverage_deg >= registration::leastCoverage_deg;
}

AddedUncertainty addedUncertainty(double coverage_deg, const PartStructure& structure, Recognition& result)
{
    AddedUncertainty added;
    added.variance_ratio = structure.variance_ratio;
    added.passes_um = structure.passes_um;
    if (result.parameters.scanner_accuracy_mm)
        added.scanner_um = 1e3 * *result.parameters.scanner_accuracy_mm;
    else
        result.notes.push_back({notes::uncertaintyNoiseOnly, {}});
    if (!(coverage_deg < recognitionLimits.full_coverage_deg)) return added;
    added.ovality_um = ovalityFactor(coverage_deg) * std::max(recognitionLimits.least_ovality_um, added.scanner_um);
    if (coverage_deg >= recognitionLimits.half_coverage_deg)
        result.notes.push_back(
            {notes::coveragePartial, {{"coverage_deg", coverage_deg}, {"added_um", added.ovality_um}}});
    return added;
}

/// Frame, rows, meridian and gaps of the outside.
void takeOutside(const Outline& outside, const RevolutionFit& fit, const AddedUncertainty& added, Recognition& result)
{
    const double zero = outside.model.planes.front().z_mm;
    const Eigen::Isometry3d along(Eigen::Translation3d(0, 0, -zero));
    result.part_T_scan = along * fit.axis_T_scan;
    const Eigen::Isometry3d scan_T_part = result.part_T_scan.inverse();
    result.axis_point_mm = scan_T_part.translation();
    result.axis_direction = scan_T_part.linear().col(2);
    result.spot_mm = outside.model.spot_mm;
    result.segments = rowsOf(outside, zero, fit.coverage_deg, added);
    result.merged = outside.merged;
    for (MergedJunction& junction : result.merged) junction.z_mm -= zero;
    if (!result.merged.empty())
        result.notes.push_back({notes::rowsMerged, {{"count", static_cast<std::int64_t>(result.merged.size())}}});
    addMeridian(outside, zero, false, 0, result.meridian);
    for (const Gap& gap : outside.gaps) {
        result.gaps.push_back({gap.z_start_mm - zero, gap.z_end_mm - zero});
        result.notes.push_back(
            {notes::gapInData,
             {{"z_start_mm", result.gaps.back().z_start_mm}, {"z_end_mm", result.gaps.back().z_end_mm}}});
        result.complete = false;
    }
    describeEnds(outside, result);
}

void takeMarks(const std::vector<ShaftMark>& marks, std::vector<ShaftMark> stretches, double zero_mm,
               Recognition& result)
{
    result.marks = withStretches(marks, stretches);
    for (ShaftMark& mark : stretches) {
        *mark.z_start_mm -= zero_mm;
        *mark.z_end_mm -= zero_mm;
    }
    widenRows(stretches, result.segments);
    for (ShaftMark& mark : result.marks) {
        *mark.z_start_mm = std::max(0.0, *mark.z_start_mm - zero_mm);
        *mark.z_end_mm = std::min(result.ends.back().z_mm, *mark.z_end_mm - zero_mm);
    }
    nameRoughRows(result);
    if (!result.marks.empty())
        result.notes.push_back({notes::marksFound, {{"count", static_cast<std::int64_t>(result.marks.size())}}});
}

/// Balls at the ends, as marks in order of z.
void addBalls(const Outline& outside, Recognition& result)
{
    for (ShaftMark& mark : ballMarks(outside, result.segments)) {
        const bool is_free = *mark.z_start_mm <= result.segments.front().z_start_mm;
        result.notes.push_back({notes::endIsBall,
                                {{"end", is_free ? LT_TEXT("Engine", "free end") : LT_TEXT("Engine", "chuck end")},
                                 {"diameter_mm", *mark.diameter_mm},
                                 {"unseen_diameter_mm", *outside.balls[is_free ? 0 : 1]}}});
        result.marks.insert(is_free ? result.marks.begin() : result.marks.end(), std::move(mark));
    }
}

void noteRoughZones(const Outline& outside, Recognition& result)
{
    const double zero = outside.model.planes.front().z_mm;
    for (const RoughZone& zone : outside.rough) {
        const double from = zone.z_start_mm - zero, to = zone.z_end_mm - zero;
        std::int64_t row = 1;
        for (std::size_t i = 0; i < result.segments.size(); ++i)
            if (result.segments[i].z_start_mm < (from + to) / 2) row = static_cast<std::int64_t>(i) + 1;
        if (zone.eccentric_mm > 0)
            result.notes.push_back(
                {notes::segmentNotCoaxial,
                 {{"row", row}, {"z_start_mm", from}, {"z_end_mm", to}, {"offset_mm", zone.eccentric_mm}}});
        else
            result.notes.push_back({notes::roughZone, {{"z_start_mm", from}, {"z_end_mm", to}}});
    }
}

/// The steps and the shaft of the published method in place of the rows'.
void addPublishedMethod(const std::vector<Vector3d>& points, Recognition& result, const Progress& progress)
{
    const PaperResult published = paperSteps(points, result.axis_direction, result.parameters, progress);
    result.method_used = "paper";
    result.paper_steps = published.steps;
    const double cosine = std::min(1.0, std::abs(published.axis.dot(result.axis_direction)));
    result.paper_axis_off_deg = std::acos(cosine) * 180 / std::numbers::pi;
    result.notes.push_back({notes::paperMethod, {}});
    result.shaft = shaftOf(published.steps);
}

Recognition recognizeOnce(const Scan& scan, const RecognitionParameters& parameters, const Progress& progress,
                          const LeftOut* left_out = nullptr);

/// Is all that would be cut loose points within a prism or teeth? Their corners are thin and stand clear of the walls.
bool cutsOnlyCorners(const std::vector<SceneGroup>& groups, const UsedPoints& used, const Progress& progress)
{
    if (!std::all_of(groups.begin(), groups.end(),
                     [](const SceneGroup& group) { return group.kept || group.kind == "clutter"; }))
        return false;
    const std::vector<NotRoundStretch> stretches =
        notRoundStretches(used.cloud, used.walls.sigma_mm, used.fit, progress);
    return std::all_of(groups.begin(), groups.end(), [&](const SceneGroup& group) {
        const double z_mm = used.fit.onAxis((group.min_mm + group.max_mm) / 2).z();
        return group.kept || std::any_of(stretches.begin(), stretches.end(), [&](const NotRoundStretch& stretch) {
                   return isOtherThanTurned(stretch.shape.kind) &&
                          *stretch.mark.z_start_mm<z_mm&& * stretch.mark.z_end_mm> z_mm;
               });
    });
}

/// The recognition without what lies about the part, now that its axis and walls are known; none where nothing does.
std::optional<Recognition> withoutSurroundings(const Scan& scan, const RecognitionParameters& parameters,
                                               const LeftOut& now, const UsedPoints& used, const Progress& progress)
{
    const std::optional<LeftOut> next = leftOutNext(now, used, parameters, progress);
    if (!next || (!next->zones && cutsOnlyCorners(next->scene.groups, used, progress.quiet()))) return std::nullopt;
    try {
        return recognizeOnce(scan, parameters, progress, &*next);
    } catch (const Error& error) {
        // Without the surroundings there is no part: then they are part of it. Zones are left out as asked.
        if (error.code().kind != ErrorKind::NoAnswer || next->zones) throw;
        return std::nullopt;
    }
}

/// Marks of the outside in the frame of the outline.
std::vector<ShaftMark> marksOf(const Meridian& meridian, const PartFit& found, const Progress& progress)
{
    const StructureInput seen = found.seen(meridian.cloud);
    const WallScan scan{meridian.cloud, found.outside.model, meridian.scanner, found.outside.surface_scan};
    std::vector<ShaftMark> holes = crossHoles(scan, found.structure.map, found.surface, found.form_mm, progress);
    const std::vector<ShaftMark> circles =
        boltCircles(seenFaces(meridian.cloud, found.outside, seen.bore, progress), progress);
    holes.insert(holes.end(), circles.begin(), circles.end());
    return withHoles(findMarks(meridian.cloud, found.outside, seen.bore, meridian.scanner, progress), holes);
}

/// Recognises all points, or those that `parameters` keep, without `left_out`.
Recognition recognizeOnce(const Scan& scan, const RecognitionParameters& parameters, const Progress& progress,
                          const LeftOut* left_out)
{
    PartPoints part = pointsOf(scan, progress);
    Recognition result;
    result.parameters = parameters;
    result.method_used = "robust";
    const LeftOut now =
        left_out ? *left_out
                 : leftOutFirst(part.all(), parameters, progress.part(0, 0.1, LT_TEXT("Engine", "Surroundings")));
    leaveOut(now, part, result, progress);
    if (scan.isMesh()) roundFacets(part, result, progress.part(0.1, 0.2));
    RevolutionFit fit = fitAxis(part.all(), parameters.free_end, progress.part(0.1, 0.4, LT_TEXT("Engine", "Axis")));
    const bool is_spoilt = mayBeSpoilt(fit, parameters);
    if (!is_spoilt && !registration::isBodyOfRevolution(fit))
        if (const auto next = leftOutWithoutAxis(now, part.all(), parameters, progress))
            return recognizeOnce(scan, parameters, progress.part(0.4, 1), &*next);
    if (!is_spoilt) judgeAxis(fit, result.notes);
    Meridian meridian = meridianOf(part, fit, progress.part(0.4, 0.6, LT_TEXT("Engine", "Meridian")));
    if (auto better = withoutSurroundings(scan, parameters, now, {part.all(), fit, meridian.cloud, meridian.coarse},
                                          progress.part(0.6, 1)))
        return *std::move(better);
    const MadeRound stretches = makeRound(part, parameters.free_end, fit, meridian, progress.part(0.6, 0.6));
    const std::vector<Vector3d>& points = part.all();
    if (is_spoilt) judgeAxis(fit, result.notes);
    const std::vector<Cut> cuts = cutsOf(now, fit);
    endChainsAt(cuts, meridian.coarse);
    endChainsAt(cuts, meridian.fine);
    result.noise_mm = meridian.coarse.sigma_mm;
    result.points_used = static_cast<std::int64_t>(points.size());

    const Progress fitting = progress.part(0.6, 1, LT_TEXT("Engine", "Segments"));
    PartFit found = fitPart({points, fit, meridian, cuts, now.scene.support, parameters.form_tolerance_mm}, fitting);
    result.notes.insert(result.notes.end(), found.notes.begin(), found.notes.end());
    result.variance_ratio = found.structure.variance_ratio;
    const AddedUncertainty added = addedUncertainty(fit.coverage_deg, found.structure, result);
    if (parameters.length_mm) applyStatedLength(*parameters.length_mm, result.variance_ratio, found.outside);
    widenEnds(stretches.unsure_ends, found.outside);
    const double zero = found.zero_mm();
    takeOutside(found.outside, fit, added, result);
    if (found.bore) addSeenBores(*found.bore, zero, result.ends.back().z_mm, fit, added, result);
    takeMarks(marksOf(meridian, found, fitting), stretches.marks, zero, result);
    addBalls(found.outside, result);
    noteRoughZones(found.outside, result);
    describeStructure(found.seen(meridian.cloud), found.structure, zero, result, fitting);
    if (!registration::isBodyOfRevolution(fit) && result.unexplained.empty())
        registration::refuseRevolution(fit, "scan");
    finishRows(found.outside, result);
    result.basis = std::make_shared<const RecognitionBasis>(
        RecognitionBasis{found.outside, fit.axis_T_scan, fit.coverage_deg, added});
    if (parameters.method == RecognitionMethod::Paper) addPublishedMethod(points, result, fitting);
    if (result.complete) result.volume_mm3 = volume_mm3(result.shaft);
    progress.report(1);
    return result;
}

/// True when nothing was cut off but a few points that belong to no object of the scene.
bool onlyFlyingPointsCut(const Recognition& result)
{
    double all = 0, cut = 0;
    for (const SceneGroup& group : result.scene) {
        all += static_cast<double>(group.points);
        if (group.kept) continue;
        if (group.kind != "clutter") return false;
        cut += static_cast<double>(group.points);
    }
    return cut > 0 && cut <= recognitionLimits.flying_share * all;
}

/// The same without flying points; none when there are none, or the rest is no part either.
std::optional<Recognition> withoutFlyingPoints(const Scan& scan, const RecognitionParameters& asked,
                                               const Progress& progress)
{
    RecognitionParameters parameters = asked;
    parameters.scene = SceneUse::Cut;
    try {
        Recognition result = recognizeOnce(scan, parameters, progress);
        if (!onlyFlyingPointsCut(result)) return std::nullopt;
        result.parameters = asked;
        return result;
    } catch (const Error&) {
        return std::nullopt;  // the answer about all points says why
    }
}

}  // namespace

Recognition recognize(const Scan& scan, const RecognitionParameters& parameters, const Progress& progress)
{
    for (const Field<RecognitionParameters>& field : fields<RecognitionParameters>())
        check(field.info, field.get(parameters));
    const bool may_cut = parameters.scene == SceneUse::Auto;
    try {
        Recognition result = recognizeOnce(scan, parameters, progress);
        if (!may_cut || result.gaps.empty() || !result.scene.empty()) return result;
        // Flying points hide stretches of the meridian, which look like gaps.
        auto cut = withoutFlyingPoints(scan, parameters, progress.quiet());
        return cut && cut->gaps.size() < result.gaps.size() ? *std::move(cut) : std::move(result);
    } catch (const Error& error) {
        if (!may_cut || error.code().kind != ErrorKind::NoAnswer) throw;
        if (auto cut = withoutFlyingPoints(scan, parameters, progress.quiet())) return *std::move(cut);
        throw;
    }
}

}  // namespace lathelier::features
