#include "engine/registration/compare.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/registration/compare_plan.h"
#include "engine/registration/default_reach.h"
#include "engine/registration/drawn_reference.h"
#include "engine/registration/general/general.h"
#include "engine/registration/neighbours/cloud_figure.h"
#include "engine/registration/point_checks.h"
#include "engine/registration/point_tasks.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution_deviation.h"
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

/// Samples, overlap and reach of a comparison (README, "Thresholds").
struct CompareThresholds {
    std::size_t mesh_samples = 300000;   ///< points on a mesh that its axis is fitted to
    double least_overlap_percent = 50;   ///< of the copy's points near the reference
    double coarse_sagitta_share = 2e-5;  ///< of the part's size: with a larger sagitta of the facets there is a note
    int reach_rounds = 3;                ///< the reach of a general part is adapted to its scatter at most so often,
    double least_growth = 1.05;          ///< and only where it grows by more than this factor
};
constexpr CompareThresholds compareThresholds{};

constexpr std::size_t movedPerTask = 65536;

/// Points of the surface: the cloud itself, or samples of the mesh.
class SurfacePoints {
public:
    SurfacePoints(const Scan& scan, const char* role, const Progress& progress) : scan_(scan)
    {
        if (scan.isMesh()) samples_ = sampleSurface(scan, compareThresholds.mesh_samples, 0, progress);
        checkPoints(points_mm(), role, progress);
    }

    const std::vector<Vector3d>& points_mm() const { return scan_.isMesh() ? samples_.points_mm : scan_.points_mm; }

private:
    const Scan& scan_;
    Scan samples_;
};

std::vector<Vector3d> movedPoints(const std::vector<Vector3d>& points, const Eigen::Isometry3d& pose,
                                  const Progress& progress)
{
    std::vector<Vector3d> result(points.size());
    parallelFor(points.size(), movedPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = pose * points[i];
    });
    return result;
}

/// Distance to the meridian of a turned cloud, to the triangles of a mesh, to the surface of any other cloud; of the
/// last two also the direction in which it was measured.
void measureDeviations(const Scan& reference, const GeneralReference* prepared, const ComparePlan& plan,
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
    parallelFor(moved_copy.size(), taskPoints, progress, [&](std::size_t begin, std::size_t end) {
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
    if (sagitta > compareThresholds.coarse_sagitta_share * size_mm)
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
void summariseDeviations(CompareResult& result, const LeftOut& left_out, double max_distance_mm, bool is_full,
                         const Progress& progress)
{
    const std::vector<float> deviations = finiteOf(result.deviation_mm);
    const auto count = static_cast<double>(result.used.size());
    const auto in_question = count - static_cast<double>(left_out.zones);
    const double near_percent = in_question > 0 ? 100 * static_cast<double>(deviations.size()) / in_question : 0;
    if (near_percent < compareThresholds.least_overlap_percent)
        throw Error(errors::partsDoNotMatch, {{"overlap_percent", near_percent}});
    result.statistics = summarise(deviations, progress);
    result.statistics.points_excluded = static_cast<std::int64_t>(result.used.size() - deviations.size());
    result.statistics.overlap_percent = 100 * static_cast<double>(deviations.size()) / count;
    if (is_full) result.histogram = histogramOf(deviations, progress);
    if (left_out.far > 0)
        result.notes.push_back({notes::outliersExcluded, {{"count", left_out.far}, {"distance_mm", max_distance_mm}}});
    if (left_out.zones > 0) result.notes.push_back({notes::zonesExcluded, {{"count", left_out.zones}}});
    judge(result, result.parameters, progress);
}

/// The stages of one comparison.
class Comparison {
public:
    /// `drawn`: the meridian of a reference that is drawn; the scan is its mesh then.
    Comparison(const Scan& reference, const Contour* drawn, const Scan& copy, const CompareParameters& parameters,
               const Progress& progress, CompareDetail detail)
        : reference_(reference),
          drawn_(drawn),
          copy_(copy),
          referenceSurface_(reference, "reference", progress),
          copySurface_(copy, "copy", progress),
          isFull_(detail == CompareDetail::Full),
          progress_(progress)
    {
        result_.parameters = parameters;
    }

    CompareResult run()
    {
        plan_ = makePlan(referenceSurface_.points_mm(), copySurface_.points_mm(), result_.parameters, result_.notes,
                         progress_.part(0.02, 0.4));
        result_.method_used = plan_.method;
        align(progress_.part(0.4, 0.5, LT_TEXT("Engine", "Alignment")));
        if (!plan_.reference_turned) refuseAlongAxis(result_.parameters);
        const Progress measuring = progress_.part(0.5, 0.75, LT_TEXT("Engine", "Deviations"));
        measure(measuring);
        noteFacets(measuring);
        leaveOut(measuring);
        // In parallel: each has serial sections, and they are independent.
        parallelFor(isFull_ ? 2 : 1, 1, progress_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (i == 0)
                    summariseSurface(measuring);
                else
                    measureClouds();
        });
        progress_.report(1);
        return std::move(result_);
    }

private:
    bool isByAxes() const { return plan_.method == CompareMethod::Revolution; }

    void align(const Progress& aligning)
    {
        if (isByAxes())
            alignByAxes(aligning);
        else
            alignByPlanes(aligning);
        result_.notes.insert(result_.notes.end(), result_.alignment.notes.begin(), result_.alignment.notes.end());
    }

    /// Axis on axis, and a shift by the shoulders. Error notConverged.
    void alignByAxes(const Progress& aligning)
    {
        ShoulderPair shoulders = findShoulders(referenceSurface_.points_mm(), plan_.reference.fit,
                                               copySurface_.points_mm(), plan_.copy.fit, aligning);
        plan_.reference.shoulders = std::move(shoulders.reference);
        plan_.copy.shoulders = std::move(shoulders.copy);
        plan_.reference.ends = std::move(shoulders.reference_ends);
        plan_.copy.ends = std::move(shoulders.copy_ends);
        result_.alignment = alignRevolution(plan_.reference, plan_.copy, result_.parameters.initial);
        if (!result_.alignment.converged)
            throw Error(errors::notConverged,
                        {{"iterations", std::int64_t{result_.alignment.iterations}}, {"role", std::string("copy")}});
    }

    /// By the surface; a reference that is turned has its meridian all the same.
    void alignByPlanes(const Progress& aligning)
    {
        prepared_ = drawn_ ? prepareReference(reference_, *drawn_, aligning.part(0, 0.4))
                           : prepareReference(reference_, aligning.part(0, 0.4));
        result_.alignment =
            alignGeneral(*prepared_, copy_, plan_.method, result_.parameters.initial, aligning.part(0.4, 1));
        if (!plan_.reference_turned) return;
        const std::vector<Vector3d>& points = referenceSurface_.points_mm();
        const RevolutionFit& fit = plan_.reference.fit;
        plan_.reference.shoulders = findShoulders(points, fit, points, fit, aligning).reference;
        result_.alignment.reference_axis = axisOf(fit);
    }

    /// The deviation of every point of the copy. The scatter of a general part is known only after the first
    /// deviations; the reach is adapted to it.
    void measure(const Progress& measuring)
    {
        const std::size_t notes_before = result_.notes.size();
        movedCopy_mm_ = movedPoints(copy_.points_mm, result_.alignment.reference_T_copy, measuring);
        if (plan_.reference_turned) line_.emplace(plan_.reference, referenceSurface_.points_mm(), measuring);
        size_mm_ = robustSize_mm(referenceSurface_.points_mm());
        const double noise_mm = isByAxes() ? std::max(plan_.reference.fit.sigma_mm, plan_.copy.fit.sigma_mm)
                                           : prepared_->surface->scatter_mm();
        const std::optional<double>& given_mm = result_.parameters.max_distance_mm;
        reach_mm_ = given_mm.value_or(defaultReach_mm(size_mm_, noise_mm));
        measureOnce(measuring.part(0, 0.8));
        for (int i = 0; i < compareThresholds.reach_rounds && !isByAxes() && !given_mm; ++i) {
            const double reach_mm = defaultReach_mm(size_mm_, noise_mm, scatterOf(finiteOf(result_.deviation_mm)));
            if (reach_mm < compareThresholds.least_growth * reach_mm_) break;
            reach_mm_ = reach_mm;
            result_.notes.erase(result_.notes.begin() + static_cast<std::ptrdiff_t>(notes_before), result_.notes.end());
            measureOnce(measuring.part(0.8, 1));
        }
    }

    void measureOnce(const Progress& progress)
    {
        if (drawn_) return measureDrawn(*drawn_, movedCopy_mm_, reach_mm_, result_, direction_, progress);
        measureDeviations(reference_, prepared_ ? &*prepared_ : nullptr, plan_, line_ ? &*line_ : nullptr,
                          movedCopy_mm_, reach_mm_, result_, direction_, progress);
    }

    void noteFacets(const Progress& measuring)
    {
        const RevolutionFit& fit = plan_.reference.fit;
        if (line_ && !drawn_ && reference_.isMesh())
            facets_mm_ = largestSagitta_mm(reference_, fit.axis_T_scan, measuring);
        if (plan_.reference_turned && !drawn_)
            noteCoarseFacets(reference_, "reference", fit, size_mm_, result_.notes, measuring);
        if (isByAxes()) noteCoarseFacets(copy_, "copy", plan_.copy.fit, size_mm_, result_.notes, measuring);
    }

    /// Points that are far from the reference or in an excluded zone do not count.
    void leaveOut(const Progress& measuring)
    {
        result_.used.resize(movedCopy_mm_.size());
        for (std::size_t i = 0; i < movedCopy_mm_.size(); ++i) {
            result_.used[i] = std::isnan(result_.deviation_mm[i]) ? 0 : 1;
            leftOut_.far += result_.used[i] ? 0 : 1;
        }
        if (line_) leftOut_.zones = excludeZones(plan_.reference, *line_, movedCopy_mm_, result_, measuring);
    }

    /// Local means, statistics and verdict; of a body of revolution meridian and map.
    void summariseSurface(const Progress& measuring)
    {
        // A scan compared with itself: single points keep their deviation, local means are 0.
        const bool is_same = reference_.points_mm == copy_.points_mm;
        std::vector<float> own_noise;
        if (is_same) {
            result_.notes.push_back({notes::samePoints, {}});
            own_noise = result_.deviation_mm;
            for (float& deviation : result_.deviation_mm)
                if (!std::isnan(deviation)) deviation = 0;
        }
        SurfaceWindows windows =
            line_ ? revolutionWindows(plan_.reference, *line_, movedCopy_mm_, result_, facets_mm_, measuring)
                  : generalWindows(movedCopy_mm_, direction_, result_, measuring);
        if (line_ && isFull_) windows.automatic_zones_mm = automaticZones(plan_.reference, *line_);
        result_.windows = std::make_shared<const SurfaceWindows>(std::move(windows));
        if (is_same) result_.deviation_mm = std::move(own_noise);
        summariseDeviations(result_, leftOut_, reach_mm_, isFull_, measuring);
        if (line_ && isFull_) describeRevolution(plan_.reference, *line_, movedCopy_mm_, result_, measuring);
    }

    void measureClouds()
    {
        const CloudFigure clouds =
            compareClouds(referenceSurface_.points_mm(), movedCopy_mm_, result_.used, reach_mm_,
                          progress_.part(0.75, 1, LT_TEXT("Engine", "Distances from cloud to cloud")));
        result_.cloud_to_cloud_rmse_mm = clouds.rmse_mm;
        result_.cloud_to_cloud_rmse_error_mm = clouds.standard_error_mm;
        result_.sampling_floor_mm = clouds.sampling_floor_mm;
    }

    const Scan& reference_;
    const Contour* drawn_;
    const Scan& copy_;
    SurfacePoints referenceSurface_, copySurface_;
    bool isFull_;
    Progress progress_;
    CompareResult result_;
    ComparePlan plan_;
    std::optional<GeneralReference> prepared_;  ///< unless the parts are aligned by their axes
    std::optional<MeridianLine> line_;          ///< of a reference that is a body of revolution
    std::vector<Vector3d> movedCopy_mm_;        ///< in the reference's frame
    std::vector<Eigen::Vector3f> direction_;    ///< in which each deviation is measured; empty along a meridian
    double size_mm_ = 0;                        ///< of the reference
    double reach_mm_ = 0;                       ///< points further away do not count
    double facets_mm_ = 0;                      ///< sagitta of a mesh that is the reference of a body of revolution
    LeftOut leftOut_;
};

/// Checks the parameters and compares.
CompareResult compareWith(const Scan& reference, const Contour* drawn, const Scan& copy,
                          const CompareParameters& parameters, const Progress& progress, CompareDetail detail)
{
    for (const Field<CompareParameters>& field : fields<CompareParameters>()) check(field.info, field.get(parameters));
    checkZones(parameters.zones);
    return Comparison(reference, drawn, copy, parameters, progress, detail).run();
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
