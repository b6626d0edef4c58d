#include "engine/features/recognition.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/features/features_codes.h"
#include "engine/features/marks/marks.h"
#include "engine/features/nominal/snap.h"
#include "engine/features/outline/bore_rows.h"
#include "engine/features/outline/dimensions.h"
#include "engine/features/outline/outline.h"
#include "engine/features/paper_method.h"
#include "engine/features/recognition_basis.h"
#include "engine/features/recognition_finish.h"
#include "engine/features/scene/left_out.h"
#include "engine/features/scene/scene_support.h"
#include "engine/features/walls/mesh_points.h"
#include "engine/registration/point_checks.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution_refusal.h"
#include "engine/registration/surface/surface_samples.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;
using registration::RevolutionFit;

constexpr std::size_t meshSamples = 400000;
constexpr double fineBin_mm = 0.1;
constexpr double leastPointsPerBin = 25;

RevolutionFit fitAxis(const std::vector<Vector3d>& points, FreeEnd free_end, const Progress& progress)
{
    RevolutionFit fit = registration::fitRevolution(points, progress);
    registration::orientAxis(fit);
    if (free_end == FreeEnd::Last) fit = registration::reversed(fit);
    return fit;
}

/// Notes about the fit, or its refusal.
void judgeAxis(const RevolutionFit& fit, Notes& notes)
{
    registration::remarkRevolution(fit, "scan", notes);
    if (!registration::isBodyOfRevolution(fit)) registration::refuseRevolution(fit, "scan");
}

/// May points that are not the part's be the reason that this is no body of revolution?
bool mayBeSpoilt(const RevolutionFit& fit, const RecognitionParameters& parameters)
{
    const bool may_leave_out = parameters.scene != SceneUse::Keep || !parameters.exclude_z_mm.empty();
    const bool has_axis =
        fit.not_turned == registration::NotTurned::NotRound || fit.not_turned == registration::NotTurned::SeveralParts;
    return may_leave_out && has_axis && fit.iterations > 0 && fit.coverage_deg >= registration::leastCoverage_deg;
}

std::vector<Vector3d> onAxis(const std::vector<Vector3d>& points, const RevolutionFit& fit, const Progress& progress)
{
    std::vector<Vector3d> moved(points.size());
    parallelFor(points.size(), 32768, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) moved[i] = fit.onAxis(points[i]);
    });
    return moved;
}

double largestRadius(const RevolutionFit& fit)
{
    double largest = 0;
    for (const double r : fit.profile.radius_mm) largest = std::isnan(r) ? largest : std::max(largest, r);
    return largest;
}

/// Points of a coarse mesh are moved onto the round surface through its vertices.
void roundFacets(const Scan& mesh, const std::vector<registration::SurfaceSample>& samples,
                 std::vector<Vector3d>& points, Recognition& result, const Progress& progress)
{
    constexpr int rounds = 2;  // the axis of the flat facets differs from that of their vertices
    double sagitta_mm = 0;
    for (int round = 0; round < rounds; ++round) {
        const RevolutionFit fit = registration::fitRevolution(points, progress);
        if (!registration::isBodyOfRevolution(fit)) break;
        RoundedPoints rounded = roundedPoints(mesh, samples, fit, progress);
        if (rounded.points.empty()) break;
        points = std::move(rounded.points);
        sagitta_mm = rounded.sagitta_mm;
    }
    if (sagitta_mm > 0) result.notes.push_back({notes::facetsRounded, {{"sagitta_mm", sagitta_mm}}});
}

template <class T>
void keepOnly(const std::vector<std::uint8_t>& kept, std::vector<T>& items)
{
    std::size_t next = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (kept[i]) items[next++] = items[i];
    items.resize(next);
}

/// Adds the note sceneCut.
void noteSceneCut(const Scene& scene, Recognition& result)
{
    result.scene = scene.groups;
    const auto all = static_cast<std::int64_t>(scene.kept.size());
    const auto count = [&](const char* kind) {
        std::int64_t sum = 0;
        for (const SceneGroup& group : scene.groups) sum += group.kind == kind ? group.points : 0;
        return sum;
    };
    result.notes.push_back({notes::sceneCut,
                            {{"cut_points", all - scene.groups.front().points},
                             {"points", all},
                             {"turntable_points", count("turntable")},
                             {"clamp_points", count("clamp")},
                             {"clutter_points", count("clutter")}}});
}

/// The end on the turntable lies in its plane; its own points were removed with the plane.
void placeEndOnSupport(const SupportPlane& support, const RevolutionFit& fit, Outline& outline, Recognition& result)
{
    const double first = outline.model.planes.front().z_mm, last = outline.model.planes.back().z_mm;
    if (!endOnSupport(support, fit, outline)) return;
    const double before = first - outline.model.planes.front().z_mm, behind = outline.model.planes.back().z_mm - last;
    const bool free = before != 0;
    result.notes.push_back({notes::endOnSupport,
                            {{"end", free ? LT_TEXT("Engine", "free end") : LT_TEXT("Engine", "chuck end")},
                             {"moved_mm", free ? before : behind}}});
}

/// Rows of a bore from its mouth inward.
std::vector<RecognizedRow> fromMouth(std::vector<RecognizedRow> rows, ShaftEnd mouth)
{
    if (mouth == ShaftEnd::Free) return rows;
    std::reverse(rows.begin(), rows.end());
    for (RecognizedRow& row : rows) {
        std::swap(row.start_diameter_mm, row.end_diameter_mm);
        std::swap(row.uncertainty.start_diameter_um, row.uncertainty.end_diameter_um);
    }
    return rows;
}

/// Bores: stretches of the inner outline that reach an end of the part. One that reaches both is cut at its narrowest
/// row only where that is hidden; else it is a through bore.
void addSeenBores(const Outline& inner, double zero_mm, double length_mm, const RevolutionFit& fit,
                  const AddedUncertainty& added, Recognition& result)
{
    constexpr double near_mm = 1;
    std::vector<RecognizedRow> rows = rowsWithinPart(rowsOf(inner, zero_mm, fit.coverage_deg, added), length_mm);
    if (rows.empty()) return;
    // A cylinder that continues behind a stretch without points is one row.
    for (std::size_t i = 0; i + 1 < rows.size();) {
        RecognizedRow &a = rows[i], &b = rows[i + 1];
        const bool same = a.kind == RowKind::Cylinder && b.kind == RowKind::Cylinder &&
                          std::abs(a.end_diameter_mm - b.start_diameter_mm) < 0.05;
        if (!same || b.z_start_mm - a.z_end_mm < 0.05) {
            ++i;
            continue;
        }
        const double wa = static_cast<double>(a.points + 1), wb = static_cast<double>(b.points + 1);
        a.start_diameter_mm = a.end_diameter_mm = (a.start_diameter_mm * wa + b.start_diameter_mm * wb) / (wa + wb);
        a.z_end_mm = b.z_end_mm;
        a.uncertainty.z_end_um = b.uncertainty.z_end_um;
        a.points += b.points;
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        if (rows[i + 1].z_start_mm - rows[i].z_end_mm > 0.05) {
            result.notes.push_back(
                {notes::boreNotSeen, {{"z_start_mm", rows[i].z_end_mm}, {"z_end_mm", rows[i + 1].z_start_mm}}});
            result.complete = false;
        }
    std::vector<RecognizedRow> from_free, from_chuck;
    std::size_t gap = rows.size();
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        if (rows[i + 1].z_start_mm - rows[i].z_end_mm > 0.05) gap = i + 1;
    const bool free = rows.front().z_start_mm<near_mm, chuck = rows.back().z_end_mm> length_mm - near_mm;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (free && (i < gap || !chuck))
            from_free.push_back(rows[i]);
        else if (chuck)
            from_chuck.push_back(rows[i]);
    if (free && chuck && gap == rows.size()) from_chuck.clear();
    if (!from_free.empty()) from_free.front().z_start_mm = 0;
    if (!from_chuck.empty()) from_chuck.back().z_end_mm = length_mm;
    if (free && chuck && gap == rows.size()) from_free.back().z_end_mm = length_mm;
    for (const auto& [list, mouth] : {std::pair(&from_free, ShaftEnd::Free), std::pair(&from_chuck, ShaftEnd::Chuck)}) {
        if (list->empty()) continue;
        result.bores.push_back(fromMouth(*list, mouth));
    }
    addMeridian(inner, zero_mm, true, 0, result.meridian);
}

/// Recognises all points, or those that `parameters` keep, without `left_out`.
Recognition recognizeOnce(const Scan& scan, const RecognitionParameters& parameters, const Progress& progress,
                          const LeftOut* left_out = nullptr)
{
    for (const Field<RecognitionParameters>& field : fields<RecognitionParameters>())
        check(field.info, field.get(parameters));
    std::vector<registration::SurfaceSample> samples;
    std::vector<Vector3d> own;  // unless the points of the scan are used as they are
    if (scan.isMesh()) {
        samples = registration::drawSamples(scan, meshSamples, 0, progress);
        own = flatPoints(scan, samples, progress);
    }
    const std::vector<Vector3d>& all = scan.isMesh() ? own : scan.points_mm;
    registration::checkPoints(all, "scan", progress);

    Recognition result;
    result.parameters = parameters;
    LeftOut now;
    if (left_out)
        now = *left_out;
    else
        now.scene = findScene(all, parameters.scene == SceneUse::Keep ? SceneUse::Keep : SceneUse::Auto,
                              progress.part(0, 0.1, LT_TEXT("Engine", "Surroundings")));
    const Scene& scene = now.scene;
    std::int64_t excluded = 0;
    const std::vector<std::uint8_t> kept = keptPoints(now, all, excluded);
    const bool is_cut = !kept.empty();
    if (!scene.groups.empty()) noteSceneCut(scene, result);
    if (now.zones) result.notes.push_back({notes::zonesExcluded, {{"count", excluded}}});
    if (is_cut) {
        if (!scan.isMesh()) own = scan.points_mm;
        keepOnly(kept, own);
        if (scan.isMesh()) keepOnly(kept, samples);
        registration::checkPoints(own, "scan", progress);
    }
    const std::vector<Vector3d>& points = is_cut || scan.isMesh() ? own : scan.points_mm;
    result.method_used = "robust";
    if (scan.isMesh()) roundFacets(scan, samples, own, result, progress.part(0.1, 0.2));
    const RevolutionFit fit = fitAxis(points, parameters.free_end, progress.part(0.1, 0.4, LT_TEXT("Engine", "Axis")));
    const bool is_spoilt = mayBeSpoilt(fit, parameters);
    if (!is_spoilt && !registration::isBodyOfRevolution(fit))
        if (const auto next = leftOutWithoutAxis(now, points, parameters, progress))
            return recognizeOnce(scan, parameters, progress.part(0.4, 1), &*next);
    if (!is_spoilt) judgeAxis(fit, result.notes);
    const Progress binning = progress.part(0.4, 0.6, LT_TEXT("Engine", "Meridian"));
    const MeridianCloud cloud = meridianCloud(onAxis(points, fit, binning), binning);
    double bin = std::max(fineBin_mm, leastPointsPerBin / std::max(1.0, cloud.points_per_mm));
    Walls coarse = findWalls(cloud, bin, fit.sigma_mm, binning);
    const std::optional<registration::ScannerAxis> scanner =
        scan.isMesh() ? std::nullopt : registration::findScannerAxis(points, fit.axis_T_scan, largestRadius(fit));
    if (!scanner && bin < 2 * coarse.sigma_mm) {
        bin = 2 * coarse.sigma_mm;
        coarse = findWalls(cloud, bin, fit.sigma_mm, binning);
    }
    if (const auto next = leftOutNext(now, {points, fit, cloud, coarse}, parameters, binning)) {
        try {
            return recognizeOnce(scan, parameters, progress.part(0.6, 1), &*next);
        } catch (const Error& error) {
            // Without the surroundings there is no part: then they are part of it. Zones are left out as asked.
            if (error.code().kind != ErrorKind::NoAnswer || next->zones) throw;
        }
    }
    if (is_spoilt) judgeAxis(fit, result.notes);
    Walls fine = findWalls(cloud, bin / 2, fit.sigma_mm, binning);
    const std::vector<Cut> cuts = cutsOf(now, fit);
    endChainsAt(cuts, coarse);
    endChainsAt(cuts, fine);
    result.noise_mm = coarse.sigma_mm;
    result.points_used = static_cast<std::int64_t>(points.size());

    const Progress fitting = progress.part(0.6, 1, LT_TEXT("Engine", "Segments"));
    OutlineInput input{points, fit, cloud, coarse, fine, scanner, parameters.form_tolerance_mm, false, {}, cuts};
    std::optional<Outline> outside = fitOutline(input, fitting.part(0, 0.8));
    if (!outside)
        throw Error(errors::tooFewPoints, {{"role", std::string("scan")},
                                           {"points", static_cast<std::int64_t>(points.size())},
                                           {"minimum", std::int64_t{50}}});
    if (scene.support) placeEndOnSupport(*scene.support, fit, *outside, result);
    const double zero = outside->model.planes.front().z_mm;
    AddedUncertainty added;
    if (parameters.scanner_accuracy_mm)
        added.scanner_um = 1e3 * *parameters.scanner_accuracy_mm;
    else
        result.notes.push_back({notes::uncertaintyNoiseOnly, {}});
    if (fit.coverage_deg < 300) {
        added.ovality_um = ovalityFactor(fit.coverage_deg) * std::max(5.0, added.scanner_um);
        if (fit.coverage_deg >= 180)
            result.notes.push_back(
                {notes::coveragePartial, {{"coverage_deg", fit.coverage_deg}, {"added_um", added.ovality_um}}});
    }
    const Eigen::Isometry3d along(Eigen::Translation3d(0, 0, -zero));
    result.part_T_scan = along * fit.axis_T_scan;
    const Eigen::Isometry3d scan_T_part = result.part_T_scan.inverse();
    result.axis_point_mm = scan_T_part.translation();
    result.axis_direction = scan_T_part.linear().col(2);
    result.spot_mm = outside->model.spot_mm;
    result.segments = rowsOf(*outside, zero, fit.coverage_deg, added);
    result.merged = outside->merged;
    for (MergedJunction& junction : result.merged) junction.z_mm -= zero;
    if (!result.merged.empty())
        result.notes.push_back({notes::rowsMerged, {{"count", static_cast<std::int64_t>(result.merged.size())}}});
    addMeridian(*outside, zero, false, 0, result.meridian);
    for (const Gap& gap : outside->gaps) {
        result.gaps.push_back({gap.z_start_mm - zero, gap.z_end_mm - zero});
        result.notes.push_back(
            {notes::gapInData,
             {{"z_start_mm", result.gaps.back().z_start_mm}, {"z_end_mm", result.gaps.back().z_end_mm}}});
        result.complete = false;
    }
    describeEnds(*outside, result);
    input.bore = true;
    input.part_ends = {outside->model.planes.front(), outside->model.planes.back()};
    const std::optional<Outline> inner = fitOutline(input, fitting.part(0.8, 1));
    if (inner) addSeenBores(*inner, zero, result.ends.back().z_mm, fit, added, result);
    result.marks = findMarks(cloud, *outside, inner ? &*inner : nullptr, fitting);
    for (ShaftMark& mark : result.marks) {
        *mark.z_start_mm -= zero;
        *mark.z_end_mm -= zero;
    }
    nameRoughRows(result);
    if (!result.marks.empty())
        result.notes.push_back({notes::marksFound, {{"count", static_cast<std::int64_t>(result.marks.size())}}});
    for (const RoughZone& zone : outside->rough) {
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
    finishRows(*outside, result);
    result.basis =
        std::make_shared<const RecognitionBasis>(RecognitionBasis{*outside, fit.axis_T_scan, fit.coverage_deg, added});
    if (parameters.method == RecognitionMethod::Paper) {
        const PaperResult published = paperSteps(points, result.axis_direction, parameters, fitting);
        result.method_used = "paper";
        result.paper_steps = published.steps;
        const double cosine = std::min(1.0, std::abs(published.axis.dot(result.axis_direction)));
        result.paper_axis_off_deg = std::acos(cosine) * 180 / std::numbers::pi;
        result.notes.push_back({notes::paperMethod, {}});
        result.shaft = shaftOf(published.steps);
    }
    if (result.complete) result.volume_mm3 = volume_mm3(result.shaft);
    progress.report(1);
    return result;
}

constexpr double mostFlying = 0.05;  ///< largest share of the points that counts as flying about the part

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
    return cut > 0 && cut <= mostFlying * all;
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
