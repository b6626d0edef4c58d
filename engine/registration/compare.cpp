#include "engine/registration/compare.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/registration/cloud_distance.h"
#include "engine/registration/revolution_deviation.h"
#include "engine/registration/sampling.h"
#include "engine/registration/statistics.h"
#include "engine/registration/surface_samples.h"
#include "engine/registration/verdict.h"

namespace lathelier {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLeastPoints = 50;
constexpr std::size_t kMeshSamples = 300000;
constexpr double kLargest_mm = 1e7;        // ten kilometres: beyond it, squares of differences lose micrometres
constexpr double kLeastOverlap = 50;       // percent of the copy's points near the reference

/// Rejects what no alignment can be found for, before anything divides by its extent.
void checkPoints(const std::vector<Vector3d>& points, const char* role, const Progress& progress)
{
    const auto reject = [&](ErrorCode code, Values values) {
        values.emplace_back("role", std::string(role));
        throw Error(code, std::move(values));
    };
    if (points.size() < kLeastPoints)
        reject(ErrorCode::TooFewPoints, {{"found", static_cast<std::int64_t>(points.size())},
                                         {"minimum", static_cast<std::int64_t>(kLeastPoints)}});
    struct Sums {
        Vector3d sum = Vector3d::Zero();
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        double worst = 0;
    };
    const Vector3d origin = points.front();
    const Sums sums = parallelReduce(
        points.size(), 65536, progress, Sums{},
        [&](std::size_t begin, std::size_t end) {
            Sums part;
            for (std::size_t i = begin; i < end; ++i) {
                const double size = points[i].cwiseAbs().maxCoeff();
                if (!(size <= part.worst) || !points[i].allFinite())
                    part.worst = points[i].allFinite() ? size : INFINITY;
                if (!(size <= kLargest_mm)) break;
                const Vector3d p = points[i] - origin;
                part.sum += p;
                part.squares += p * p.transpose();
            }
            return part;
        },
        [](Sums all, const Sums& part) {
            all.sum += part.sum;
            all.squares += part.squares;
            all.worst = std::max(all.worst, part.worst);
            return all;
        });
    if (!(sums.worst <= kLargest_mm))
        reject(ErrorCode::CoordinateTooLarge, {{"found", sums.worst}, {"maximum", kLargest_mm}});
    const auto n = static_cast<double>(points.size());
    const Vector3d mean = sums.sum / n;
    const Eigen::Matrix3d scatter = sums.squares / n - mean * mean.transpose();
    const Vector3d extent = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter, Eigen::EigenvaluesOnly)
                                .eigenvalues()
                                .cwiseMax(0)
                                .cwiseSqrt();
    // Rounding of the coordinates themselves must not look like a shape.
    const double least = std::max(1e-6 * extent[2], 1e-7 * sums.worst);
    if (extent[2] <= 1e-7 * sums.worst || extent[2] == 0)
        reject(ErrorCode::PointsDegenerate, {{"found", LT_TEXT("Engine", "in one place")}});
    if (extent[1] <= least) reject(ErrorCode::PointsDegenerate, {{"found", LT_TEXT("Engine", "on a line")}});
    if (extent[0] <= least) reject(ErrorCode::PointsDegenerate, {{"found", LT_TEXT("Engine", "in a plane")}});
}

/// Points that stand for the surface: the cloud itself, or samples of the mesh.
struct Surface {
    const std::vector<Vector3d>* points = nullptr;
    Scan samples;
};

Surface surfaceOf(const Scan& scan, const char* role, const Progress& progress)
{
    Surface surface;
    surface.points = &scan.points_mm;
    if (scan.isMesh()) {
        surface.samples = sampleSurface(scan, kMeshSamples, 0, progress);
        surface.points = &surface.samples.points_mm;
    }
    checkPoints(*surface.points, role, progress);
    return surface;
}

/// Turns the frame so that z runs along the reported direction of the axis.
void faceForward(RevolutionFit& fit)
{
    const Vector3d direction = fit.axis_T_scan.linear().row(2);
    Eigen::Index dominant = 0;
    direction.cwiseAbs().maxCoeff(&dominant);
    if (direction[dominant] < 0) fit = reversed(fit);
}

void addStatistics(CompareResult& result, const std::vector<Vector3d>& reference, const std::vector<Vector3d>& copy,
                   const LeftOut& left_out, double max_distance_mm, const Progress& progress)
{
    std::vector<float> deviations;
    std::vector<Vector3d> moved;
    deviations.reserve(copy.size());
    moved.reserve(copy.size());
    for (std::size_t i = 0; i < copy.size(); ++i)
        if (result.used[i]) {
            deviations.push_back(result.deviation_mm[i]);
            moved.push_back(result.alignment.reference_T_copy * copy[i]);
        }
    DeviationStatistics& s = result.statistics;
    s = summarise(deviations, progress.part(0, 0.2));
    s.points_excluded = static_cast<std::int64_t>(copy.size()) - s.points_used;
    s.overlap_percent = 100 * static_cast<double>(s.points_used) / static_cast<double>(copy.size());
    const auto in_question = static_cast<double>(static_cast<std::int64_t>(copy.size()) - left_out.zones);
    const double near_percent = in_question > 0 ? 100 * static_cast<double>(s.points_used) / in_question : 0;
    if (near_percent < kLeastOverlap) throw Error(ErrorCode::PartsDoNotMatch, {{"overlap_percent", near_percent}});
    result.histogram = histogramOf(deviations, progress);

    if (left_out.far > 0)
        result.notes.push_back(
            {NoteCode::OutliersExcluded, {{"count", left_out.far}, {"distance_mm", max_distance_mm}}});
    if (left_out.zones > 0) result.notes.push_back({NoteCode::ZonesExcluded, {{"count", left_out.zones}}});
    judge(result, result.parameters, progress);

    const std::vector<float> nearest = nearestDistances(
        reference, moved, max_distance_mm, progress.part(0.3, 1, LT_TEXT("Engine", "Distances from cloud to cloud")));
    double squares = 0;
    double found = 0;
    for (const float distance : nearest)
        if (!std::isnan(distance)) {
            squares += static_cast<double>(distance) * distance;
            found += 1;
        }
    result.cloud_to_cloud_rmse_mm = found > 0 ? std::sqrt(squares / found) : std::numeric_limits<double>::quiet_NaN();
    result.sampling_floor_mm = samplingFloor_mm(reference, progress);
}

}  // namespace

CompareResult compare(const Scan& reference_scan, const Scan& copy_scan, const CompareParameters& parameters,
                      const Progress& progress)
{
    for (const Field<CompareParameters>& field : fields<CompareParameters>()) check(field.info, field.get(parameters));
    const Surface reference_surface = surfaceOf(reference_scan, "reference", progress);
    const Surface copy_surface = surfaceOf(copy_scan, "copy", progress);

    CompareResult result;
    result.parameters = parameters;
    result.method_used = CompareMethod::Revolution;
    TurnedPart reference, copy;
    reference.fit =
        fitRevolution(*reference_surface.points, progress.part(0.02, 0.25, LT_TEXT("Engine", "Axis of the reference")));
    copy.fit = fitRevolution(*copy_surface.points, progress.part(0.25, 0.48, LT_TEXT("Engine", "Axis of the copy")));
    for (const auto& [fit, role] : {std::pair{&reference.fit, "reference"}, std::pair{&copy.fit, "copy"}})
        if (!isBodyOfRevolution(*fit))
            throw Error(ErrorCode::NotABodyOfRevolution, {{"role", std::string(role)}, {"residual_mm", fit->sigma_mm}});
    faceForward(reference.fit);
    ShoulderPair shoulders =
        findShoulders(*reference_surface.points, reference.fit, *copy_surface.points, copy.fit, progress);
    reference.shoulders = std::move(shoulders.reference);
    copy.shoulders = std::move(shoulders.copy);
    result.alignment = alignRevolution(reference, copy, parameters.initial);
    result.notes = result.alignment.notes;

    const Progress measuring = progress.part(0.5, 1, LT_TEXT("Engine", "Deviations"));
    const double max_distance_mm =
        parameters.max_distance_mm.value_or(std::max(1.0, 10 * std::max(reference.fit.sigma_mm, copy.fit.sigma_mm)));
    const MeridianLine line(reference, *reference_surface.points, measuring);
    const LeftOut left_out =
        measureRevolution(reference, line, copy_scan.points_mm, max_distance_mm, result, measuring.part(0, 0.3));
    addStatistics(result, *reference_surface.points, copy_scan.points_mm, left_out, max_distance_mm,
                  measuring.part(0.3, 1));
    describeRevolution(reference, line, copy_scan.points_mm, result, measuring);
    progress.report(1);
    return result;
}

}  // namespace lathelier
