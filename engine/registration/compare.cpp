#include "engine/registration/compare.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/registration/default_reach.h"
#include "engine/registration/drawn_reference.h"
#include "engine/registration/general/general.h"
#include "engine/registration/neighbours/cloud_figure.h"
#include "engine/registration/point_checks.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution_deviation.h"
#include "engine/registration/revolution/revolution_refusal.h"
#include "engine/registration/statistics.h"
#include "engine/registration/surface/drawn_surface.h"
#include "engine/registration/surface/facet_sagitta.h"
#include "engine/registration/surface/surface_deviation.h"
#include "engine/registration/surface/surface_samples.h"
#include "engine/registration/verdict/general_cells.h"
#include "engine/registration/verdict/meridian_runs.h"
#include "engine/registration/verdict/revolution_cells.h"
#include "engine/registration/verdict/verdict.h"
#include "engine/registration/verdict/zone_limits.h"
#include "engine/shaft/contour_distance.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

constexpr std::size_t meshSamples = 300000;
constexpr double leastOverlap_percent = 50;  // percent of the copy's points near the reference
constexpr double coarseSagittaShare = 2e-5;  // of the part's size: with a larger sagitta of the facets there is a note

/// Points of the surface: the cloud itself, or samples of the mesh.
struct SurfacePoints {
    const std::vector<Vector3d>* points = nullptr;
    Scan samples;
};

SurfacePoints surfaceOf(const Scan& scan, const char* role, const Progress& progress)
{
    SurfacePoints surface;
    surface.points = &scan.points_mm;
    if (scan.isMesh()) {
        surface.samples = sampleSurface(scan, meshSamples, 0, progress);
        surface.points = &surface.samples.points_mm;
    }
    checkPoints(*surface.points, role, progress);
    return surface;
}

/// Axis fits of the two parts and the method that follows.
struct Plan {
    CompareMethod method = CompareMethod::Plane;
    TurnedPart reference;
    TurnedPart copy;
    bool reference_turned = false;  ///< the reference is a body of revolution
};

Note methodNote(const char* method, Text reason, const Plan& plan)
{
    Note note{notes::methodChosen, {{"method", std::string(method)}, {"reason", reason}}};
    const auto add = [&](const char* name, const RevolutionFit& fit) {
        if (fit.iterations > 0) note.values.emplace_back(name, 100 * fit.consistent_share);
    };
    add("reference_on_one_meridian_percent", plan.reference.fit);
    add("copy_on_one_meridian_percent", plan.copy.fit);
    return note;
}

/// Fits axes where needed and chooses the method. Error notABodyOfRevolution when the parameters require one.
Plan makePlan(const std::vector<Vector3d>& reference, const std::vector<Vector3d>& copy, const CompareParameters& asked,
              Notes& notes, const Progress& progress)
{
    Plan plan;
    const bool is_auto = asked.method == CompareMethod::Auto;
    const bool forced =
        asked.method == CompareMethod::Revolution || (is_auto && asked.symmetry == Symmetry::Revolution);
    if (!is_auto) plan.method = asked.method;
    if (asked.symmetry == Symmetry::None && !forced) {
        if (is_auto) notes.push_back(methodNote("plane", LT_TEXT("Engine", "symmetry is not to be used"), plan));
        return plan;
    }
    // In parallel: each has serial sections. The copy's fit may turn out not to be needed.
    const bool bothWanted = forced || is_auto;
    parallelFor(bothWanted ? 2 : 1, 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (i == 0)
                plan.reference.fit =
                    fitRevolution(reference, progress.part(0, 0.5, LT_TEXT("Engine", "Axis of the reference")));
            else
                plan.copy.fit = fitRevolution(copy, progress.part(0.5, 1, LT_TEXT("Engine", "Axis of the copy")));
    });
    plan.reference_turned = isBodyOfRevolution(plan.reference.fit);
    remarkRevolution(plan.reference.fit, "reference", notes);
    if (forced && !plan.reference_turned) refuseRevolution(plan.reference.fit, "reference");
    if (plan.reference_turned) orientAxis(plan.reference.fit);
    if (!forced && (!is_auto || !plan.reference_turned)) {
        plan.copy = {};
        if (is_auto)
            notes.push_back(methodNote("plane", LT_TEXT("Engine", "the reference is not a body of revolution"), plan));
        return plan;
    }
    const bool copy_turned = isBodyOfRevolution(plan.copy.fit);
    remarkRevolution(plan.copy.fit, "copy", notes);
    if (forced && !copy_turned) refuseRevolution(plan.copy.fit, "copy");
    if (copy_turned) orientAxis(plan.copy.fit);  // the same data give the same frame: compared with itself, exactly
    plan.method = copy_turned ? CompareMethod::Revolution : CompareMethod::Plane;
    if (is_auto)
        notes.push_back(copy_turned
                            ? methodNote("revolution", LT_TEXT("Engine", "both parts are bodies of revolution"), plan)
                            : methodNote("plane", LT_TEXT("Engine", "the copy is not a body of revolution"), plan));
    return plan;
}

std::vector<Vector3d> movedPoints(const std::vector<Vector3d>& points, const Eigen::Isometry3d& pose,
                                  const Progress& progress)
{
    std::vector<Vector3d> result(points.size());
    parallelFor(points.size(), 65536, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = pose * points[i];
    });
    return result;
}

/// Distance to the meridian of a turned cloud, to the triangles of a mesh, to the surface of any other cloud; of the
/// last two also the direction in which it was measured.
void measureDeviations(const Scan& reference, const GeneralReference* prepared, const Plan& plan,
                       const MeridianLine* line, const std::vector<Vector3d>& moved_copy, double max_distance_mm,
                       CompareResult& result, std::vector<Eigen::Vector3f>& direction, const Progress& progress)
{
    const auto toMeridian = [&] {
        return meridianDeviation(plan.reference, *line, moved_copy, max_distance_mm, progress);
    };
    if (line && !reference.isMesh()) {
        result.deviation_mm = toMeridian();
        return;
    }
    SurfaceDeviation surface = prepared ? surfaceDeviation(*prepared, moved_copy, max_distance_mm, progress)
                                        : surfaceDeviation(reference, moved_copy, max_distance_mm, progress);
    result.notes.insert(result.notes.end(), surface.notes.begin(), surface.notes.end());
    result.has_sign = surface.has_sign;
    result.deviation_mm = std::move(surface.deviation_mm);
    direction = std::move(surface.direction);
    if (surface.has_sign || !line) return;
    // Facets with contradicting orientation: the distance is to the facets, the sign from the meridian.
    const std::vector<float> sides = toMeridian();
    for (std::size_t i = 0; i < sides.size(); ++i)
        result.deviation_mm[i] = std::isnan(sides[i]) ? sides[i] : std::copysign(result.deviation_mm[i], sides[i]);
    result.has_sign = true;
    std::erase_if(result.notes, [](const Note& note) { return note.code == notes::signUndetermined; });
}

/// Distance to the meridian of a drawing.
void measureDrawn(const Contour& meridian, const std::vector<Vector3d>& moved_copy, double max_distance_mm,
                  CompareResult& result, std::vector<Eigen::Vector3f>& direction, const Progress& progress)
{
    const ContourDistance distance(meridian, max_distance_mm);
    result.has_sign = true;
    result.deviation_mm.assign(moved_copy.size(), std::numeric_limits<float>::quiet_NaN());
    direction.assign(moved_copy.size(), Eigen::Vector3f::Zero());
    parallelFor(moved_copy.size(), 16384, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const SurfacePlace place = placeOn(distance, moved_copy[i]);
            if (!place.found()) continue;
            result.deviation_mm[i] = static_cast<float>(place.distance_mm);
            direction[i] = place.normal.cast<float>();
        }
    });
}

/// The facets of a coarse mesh are no form error of the part: a note gives their sagitta.
void noteCoarseFacets(const Scan& scan, const char* role, const RevolutionFit& fit, double size_mm, Notes& notes,
                      const Progress& progress)
{
    if (!scan.isMesh()) return;
    const double sagitta = facetSagitta_mm(scan, fit.axis_T_scan, progress);
    if (sagitta > coarseSagittaShare * size_mm)
        notes.push_back({notes::facetsCoarse, {{"role", std::string(role)}, {"sagitta_mm", sagitta}}});
}

/// Without an axis there are no zones along it.
void refuseAlongAxis(const CompareParameters& asked)
{
    const auto refuse = [](const char* parameter, Value found) {
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", std::string(parameter)},
                     {"found", std::move(found)},
                     {"expected", LT_TEXT("Engine", "a body of revolution, which has an axis")}});
    };
    if (!asked.exclude_z_mm.empty()) refuse("exclude_z_mm", asked.exclude_z_mm);
    if (!asked.zones.empty()) refuse("zones", asked.zones.front().name);
}

std::vector<float> finiteOf(const std::vector<float>& values)
{
    std::vector<float> finite;
    finite.reserve(values.size());
    for (const float v : values)
        if (!std::isnan(v)) finite.push_back(v);
    return finite;
}

double scatterOf(const std::vector<float>& values)
{
    return values.empty() ? 0 : summarise(values).mad_sigma_mm;
}

struct LeftOut {
    std::int64_t far = 0;
    std::int64_t zones = 0;
};

/// Statistics, verdict and histogram. Error partsDoNotMatch when too little of the copy lies near the reference.
void summariseDeviations(CompareResult& result, const LeftOut& left_out, double max_distance_mm, CompareDetail detail,
                         const Progress& progress)
{
    const std::vector<float> deviations = finiteOf(result.deviation_mm);
    const auto count = static_cast<double>(result.used.size());
    const auto in_question = count - static_cast<double>(left_out.zones);
    const double near_percent = in_question > 0 ? 100 * static_cast<double>(deviations.size()) / in_question : 0;
    if (near_percent < leastOverlap_percent) throw Error(errors::partsDoNotMatch, {{"overlap_percent", near_percent}});
    result.statistics = summarise(deviations, progress);
    result.statistics.points_excluded = static_cast<std::int64_t>(result.used.size() - deviations.size());
    result.statistics.overlap_percent = 100 * static_cast<double>(deviations.size()) / count;
    if (detail == CompareDetail::Full) result.histogram = histogramOf(deviations, progress);
    if (left_out.far > 0)
        result.notes.push_back({notes::outliersExcluded, {{"count", left_out.far}, {"distance_mm", max_distance_mm}}});
    if (left_out.zones > 0) result.notes.push_back({notes::zonesExcluded, {{"count", left_out.zones}}});
    judge(result, result.parameters, progress);
}

/// `drawn`: the meridian of a reference that is drawn; the scan is its mesh then.
CompareResult compareWith(const Scan& reference_scan, const Contour* drawn, const Scan& copy_scan,
                          const CompareParameters& parameters, const Progress& progress, CompareDetail detail)
{
    for (const Field<CompareParameters>& field : fields<CompareParameters>()) check(field.info, field.get(parameters));
    checkZones(parameters.zones);
    const SurfacePoints reference_surface = surfaceOf(reference_scan, "reference", progress);
    const SurfacePoints copy_surface = surfaceOf(copy_scan, "copy", progress);
    const std::vector<Vector3d>& reference_points = *reference_surface.points;

    CompareResult result;
    result.parameters = parameters;
    Plan plan = makePlan(reference_points, *copy_surface.points, parameters, result.notes, progress.part(0.02, 0.4));
    result.method_used = plan.method;
    const Progress aligning = progress.part(0.4, 0.5, LT_TEXT("Engine", "Alignment"));
    std::optional<GeneralReference> prepared;
    if (plan.method == CompareMethod::Revolution) {
        ShoulderPair shoulders =
            findShoulders(reference_points, plan.reference.fit, *copy_surface.points, plan.copy.fit, aligning);
        plan.reference.shoulders = std::move(shoulders.reference);
        plan.copy.shoulders = std::move(shoulders.copy);
        plan.reference.ends = std::move(shoulders.reference_ends);
        plan.copy.ends = std::move(shoulders.copy_ends);
        result.alignment = alignRevolution(plan.reference, plan.copy, parameters.initial);
        if (!result.alignment.converged)
            throw Error(errors::notConverged,
                        {{"iterations", std::int64_t{result.alignment.iterations}}, {"role", std::string("copy")}});
    } else {
        prepared = drawn ? prepareReference(reference_scan, *drawn, aligning.part(0, 0.4))
                         : prepareReference(reference_scan, aligning.part(0, 0.4));
        result.alignment = alignGeneral(*prepared, copy_scan, plan.method, parameters.initial, aligning.part(0.4, 1));
        if (plan.reference_turned) {
            plan.reference.shoulders =
                findShoulders(reference_points, plan.reference.fit, reference_points, plan.reference.fit, aligning)
                    .reference;
            result.alignment.reference_axis = axisOf(plan.reference.fit);
        }
    }
    result.notes.insert(result.notes.end(), result.alignment.notes.begin(), result.alignment.notes.end());
    const std::size_t notes_before = result.notes.size();
    if (!plan.reference_turned) refuseAlongAxis(parameters);

    const Progress measuring = progress.part(0.5, 0.75, LT_TEXT("Engine", "Deviations"));
    const std::vector<Vector3d> moved_copy =
        movedPoints(copy_scan.points_mm, result.alignment.reference_T_copy, measuring);
    std::optional<MeridianLine> line;
    if (plan.reference_turned) line.emplace(plan.reference, reference_points, measuring);
    const double size_mm = robustSize_mm(reference_points);
    const double noise_mm = plan.method == CompareMethod::Revolution
                                ? std::max(plan.reference.fit.sigma_mm, plan.copy.fit.sigma_mm)
                                : prepared->surface->scatter_mm();
    double reach_mm = parameters.max_distance_mm.value_or(defaultReach_mm(size_mm, noise_mm));
    std::vector<Eigen::Vector3f> direction;
    const auto remeasure = [&](const Progress& own) {
        if (drawn) return measureDrawn(*drawn, moved_copy, reach_mm, result, direction, own);
        measureDeviations(reference_scan, prepared ? &*prepared : nullptr, plan, line ? &*line : nullptr, moved_copy,
                          reach_mm, result, direction, own);
    };
    remeasure(measuring.part(0, 0.8));
    // The scatter of a general part is known only after the first deviations; the reach is adapted to it.
    for (int i = 0; i < 3 && plan.method != CompareMethod::Revolution && !parameters.max_distance_mm; ++i) {
        const double reach = defaultReach_mm(size_mm, noise_mm, scatterOf(finiteOf(result.deviation_mm)));
        if (reach < 1.05 * reach_mm) break;
        reach_mm = reach;
        result.notes.erase(result.notes.begin() + static_cast<std::ptrdiff_t>(notes_before), result.notes.end());
        remeasure(measuring.part(0.8, 1));
    }
    const double facets_mm = line && !drawn && reference_scan.isMesh()
                                 ? largestSagitta_mm(reference_scan, plan.reference.fit.axis_T_scan, measuring)
                                 : 0;
    if (plan.reference_turned && !drawn)
        noteCoarseFacets(reference_scan, "reference", plan.reference.fit, size_mm, result.notes, measuring);
    if (plan.method == CompareMethod::Revolution)
        noteCoarseFacets(copy_scan, "copy", plan.copy.fit, size_mm, result.notes, measuring);
    LeftOut left_out;
    result.used.resize(moved_copy.size());
    for (std::size_t i = 0; i < moved_copy.size(); ++i) {
        result.used[i] = std::isnan(result.deviation_mm[i]) ? 0 : 1;
        left_out.far += result.used[i] ? 0 : 1;
    }
    if (line) left_out.zones = excludeZones(plan.reference, *line, moved_copy, result, measuring);
    // A scan compared with itself: single points keep their deviation, local means are 0.
    const bool is_same = reference_scan.points_mm == copy_scan.points_mm;
    std::vector<float> own_noise;
    if (is_same) {
        result.notes.push_back({notes::samePoints, {}});
        own_noise = result.deviation_mm;
        for (float& deviation : result.deviation_mm)
            if (!std::isnan(deviation)) deviation = 0;
    }
    const bool in_full = detail == CompareDetail::Full;
    const auto judgeSurface = [&] {
        SurfaceWindows windows =
            line ? revolutionWindows(plan.reference, *line, moved_copy, result, facets_mm, measuring)
                 : generalWindows(moved_copy, direction, result, measuring);
        if (line && in_full) windows.automatic_zones_mm = automaticZones(plan.reference, *line);
        result.windows = std::make_shared<const SurfaceWindows>(std::move(windows));
        if (is_same) result.deviation_mm = std::move(own_noise);
        summariseDeviations(result, left_out, reach_mm, detail, measuring);
        if (line && in_full) describeRevolution(plan.reference, *line, moved_copy, result, measuring);
    };
    const auto measureClouds = [&] {
        const CloudFigure clouds =
            compareClouds(reference_points, moved_copy, result.used, reach_mm,
                          progress.part(0.75, 1, LT_TEXT("Engine", "Distances from cloud to cloud")));
        result.cloud_to_cloud_rmse_mm = clouds.rmse_mm;
        result.cloud_to_cloud_rmse_error_mm = clouds.standard_error_mm;
        result.sampling_floor_mm = clouds.sampling_floor_mm;
    };
    // In parallel: each has serial sections, and they are independent.
    parallelFor(in_full ? 2 : 1, 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (i == 0)
                judgeSurface();
            else
                measureClouds();
    });
    progress.report(1);
    return result;
}

}  // namespace

CompareResult compare(const Scan& reference_scan, const Scan& copy_scan, const CompareParameters& parameters,
                      const Progress& progress, CompareDetail detail)
{
    return compareWith(reference_scan, nullptr, copy_scan, parameters, progress, detail);
}

CompareResult compare(const DrawnReference& reference, const Scan& copy, const CompareParameters& parameters,
                      const Progress& progress, CompareDetail detail)
{
    return compareWith(reference.mesh, &reference.meridian, copy, parameters, progress, detail);
}

}  // namespace lathelier::registration
