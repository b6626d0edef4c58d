#include "engine/registration/revolution/revolution_axis.h"
#include "engine/core/units.h"
#include "engine/registration/revolution/revolution_guess.h"
#include "engine/registration/revolution/revolution_verdict.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/registration/drawn_places.h"
#include "engine/registration/revolution/face_bins.h"
#include "engine/registration/revolution/meridian_bins.h"
#include "engine/registration/revolution/meridian_share.h"
#include "engine/registration/revolution/revolution_step.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

constexpr std::size_t guessPoints = 12000;
constexpr std::size_t coarseFitPoints = 60000;
constexpr std::size_t mostFitPoints = 200000;  // points of the sample that the axis is fitted to first
constexpr std::size_t mostPoints = 2'000'000;  // points of the final fit of axis and radii
constexpr std::size_t straightenedPerTask = 16384;

/// `count` points spread over the whole cloud.
std::vector<Vector3d> samplePoints(const std::vector<Vector3d>& points, std::size_t count)
{
    if (points.size() <= count) return points;
    std::vector<Vector3d> sample;
    sample.reserve(count);
    for (const std::size_t place : drawnPlaces(points.size(), count, 11)) sample.push_back(points[place]);
    return sample;
}

/// A start with its score on a small sample.
struct PoseTrial {
    Eigen::Isometry3d pose;
    MeridianBins bins;
    double consistent = -1;
    double on_bins = -1;

    /// Score of a trial: the consistent share of the points plus the share on active bins. The former alone is too
    /// tolerant of wide bins, the latter alone rejects a part that is mostly thread and knurl.
    double worth() const { return consistent < 0 ? -1 : consistent * on_bins; }
};

PoseTrial tryCandidate(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& pose, double noise_mm,
                       const Progress& progress)
{
    PoseTrial trial{pose, makeBins(sample, pose, 200)};
    for (int i = 0; i < 4; ++i) {
        if (!improve(sample, trial.pose, trial.bins, progress).determined) return trial;
        trial.bins = makeBins(sample, trial.pose, 200);
    }
    trial.consistent = consistentShare(sample, trial.pose, trial.bins, noise_mm);
    trial.on_bins = shareOnBins(sample, trial.pose, trial.bins, noise_mm);
    return trial;
}

/// A scanner with rows further apart than the bins leaves many short runs of empty bins; a real gap is one long run.
/// Bins that hold only spurious points count as empty: beyond the part they would look like rows.
bool isFinerThanRows(const MeridianBins& bins)
{
    std::vector<double> counts;
    for (int i = 0; i < bins.side_count; ++i)
        if (const double points = bins.bins[static_cast<std::size_t>(i)].points; points > 0) counts.push_back(points);
    if (counts.empty()) return false;
    const double middle = upperMedianInPlace(counts);
    const double least = 0.1 * middle;
    int runs = 0;
    int filled = 0;
    bool previous = false;
    for (int i = 0; i < bins.side_count; ++i) {
        const bool here = bins.bins[static_cast<std::size_t>(i)].points > least;
        if (here) ++filled;
        if (here && !previous) ++runs;
        previous = here;
    }
    return runs > std::max(3, filled / 20);
}

/// The finest bins, up to 1000 along the part, that are all filled by the rows of the scan.
MeridianBins makeFinestBins(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& pose)
{
    MeridianBins bins = makeBins(sample, pose, 1000);
    for (int count = 700; count >= 80 && isFinerThanRows(bins); count = count * 7 / 10)
        bins = makeBins(sample, pose, count);
    return bins;
}

RadiusProfile radiusProfileOf(const MeridianBins& bins, const std::vector<Sums::Bin>& sums, int first)
{
    RadiusProfile profile;
    profile.z_start_mm = bins.z_start_mm;
    profile.step_mm = bins.step_mm;
    for (int i = 0; i < bins.side_count; ++i) {
        const std::size_t place = static_cast<std::size_t>(first) + static_cast<std::size_t>(i);
        const MeridianBin& bin = bins.bins[place];
        const Sums::Bin& sum = sums[place];
        const bool known = bin.active && sum.weight > 0;
        profile.radius_mm.push_back(known ? bin.value : notANumber);
        profile.slope.push_back(known ? bin.slope : notANumber);
        profile.sigma_mm.push_back(known ? 1 / std::sqrt(sum.weight) / bin.cosine : notANumber);
        profile.points.push_back(known ? sum.weight * bin.sigma * bin.sigma : 0);
    }
    return profile;
}

std::vector<Vector3d> straightened(const std::vector<Vector3d>& points, const Bend& bend, const Progress& progress)
{
    std::vector<Vector3d> result(points.size());
    parallelFor(points.size(), straightenedPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = bend.straightened(points[i]);
    });
    return result;
}

}  // namespace

RevolutionFit fitRevolution(const std::vector<Vector3d>& points, const Progress& progress)
{
    RevolutionFit fit;
    const std::vector<Vector3d> small = samplePoints(points, guessPoints);
    PoseTrial best;
    std::vector<PoseTrial> trials;
    int tried = 0;
    const AxisCandidates candidates = findAxisCandidates(small, progress);
    for (const Eigen::Isometry3d& candidate : candidates.axis_T_scan) {
        const PoseTrial trial = tryCandidate(small, candidate, candidates.noise_mm, progress);
        if (trial.worth() > best.worth()) best = trial;
        trials.push_back(trial);
        if ((best.consistent > 0.93 && best.on_bins > 0.6) || ++tried == 4) break;
    }
    std::vector<Vector3d> sample = samplePoints(points, coarseFitPoints);
    const auto refused = [&] {
        fit.axis_T_scan = best.pose;
        fit.sigma_mm = best.bins.sigma_mm;
        fit.not_turned = judgeRevolution(fit, sample, candidates.noise_mm);
        return fit;
    };
    if (best.consistent < 0) return refused();
    progress.report(0.3);
    const double round_mm = std::max(3 * candidates.noise_mm, 0.005 * best.bins.largest_mm);
    if (best.consistent <= 0.93)  // with a strong bend all trials score badly; the one with round sections is right
        for (const PoseTrial& trial : trials) {
            if (trial.consistent < 0) continue;
            const Bend own = findBend(small, trial.pose, trial.bins);
            if (!own.isSeen() || own.scatter_mm > round_mm) continue;
            best = trial;
            break;
        }

    // A bend is subtracted from the points in two iterations, since the radii of the first are those of the bent part.
    // Not done where the sections are not round, because their centres are not defined.
    Eigen::Isometry3d pose = best.pose;
    Bend bend = findBend(sample, pose, makeBins(sample, pose, 400));
    if (bend.isSeen() && bend.scatter_mm < round_mm) {
        const std::vector<Vector3d> first = straightened(sample, bend, progress);
        bend = Bend::sum(bend, findBend(first, pose, makeBins(first, pose, 400)));
        if (bend.isSeen()) {
            fit.bend = bend;
            if (bend.isLarge()) return refused();
            sample = straightened(sample, bend, progress);
        }
    }
    std::vector<Vector3d> chosen;
    if (points.size() > mostPoints) chosen = samplePoints(points, mostPoints);
    if (fit.bend.isSeen()) chosen = straightened(chosen.empty() ? points : chosen, fit.bend, progress);
    const std::vector<Vector3d>& all = chosen.empty() ? points : chosen;
    const std::vector<Vector3d> fewer =
        all.size() > mostFitPoints ? samplePoints(all, mostFitPoints) : std::vector<Vector3d>{};
    const std::vector<Vector3d>& votes = fewer.empty() ? all : fewer;

    MeridianBins bins;
    for (int i = 0; i < 3; ++i) {
        bins = makeBins(sample, pose, 400);
        if (!improve(sample, pose, bins, progress).determined) return refused();
        ++fit.iterations;
    }
    bins = makeFinestBins(sample, pose);
    fit.consistent_share = consistentShare(sample, pose, bins, candidates.noise_mm);
    progress.report(0.5);

    // The step shrinks at least tenfold per iteration; converged at a tenth of the statistical uncertainty. Slopes near
    // the noise may switch on and off with every step: they are fixed after a few.
    constexpr int mostSteps = 14, slopeRefiningSteps = 6;
    Step step;
    for (int i = 0; i < mostSteps && !fit.converged; ++i) {
        step = improve(votes, pose, bins, progress);
        ++fit.iterations;
        if (!step.determined) return refused();
        const double relative = std::sqrt(step.change.dot(step.hessian * step.change));  // in standard uncertainties
        fit.converged = relative < 0.1;
        if (!fit.converged && i < slopeRefiningSteps) refineSlopes(bins);
        progress.report(0.5 + 0.1 * std::min(i, 4));
    }
    if (!fewer.empty()) {
        step = improve(all, pose, bins, progress);
        ++fit.iterations;
        if (!step.determined) return refused();
    }
    fit.axis_T_scan = pose;
    fit.sigma_mm = bins.sigma_mm;
    fit.side_share = step.sums.side_weights / static_cast<double>(all.size());
    fit.covariance = covarianceOf(all, pose, bins, step, progress);
    fit.profile = radiusProfileOf(bins, step.sums.bins, 0);
    clearFaceBins(fit.profile, fit.sigma_mm);
    if (bins.wall_count > bins.side_count) fit.bore = radiusProfileOf(bins, step.sums.bins, bins.side_count);
    const std::vector<bool> rough = roughBins(sample, pose, bins);
    for (std::size_t i = 0; i < rough.size(); ++i) fit.rough_mm.push_back(rough[i] ? bins.bins[i].value : notANumber);
    clearRoughFaceBins(fit.rough_mm, fit.profile, fit.sigma_mm);
    fit.not_turned = judgeRevolution(fit, sample, candidates.noise_mm);
    progress.report(1);
    return fit;
}

RevolutionFit reversed(const RevolutionFit& fit)
{
    RevolutionFit result = fit;
    for (RadiusProfile* p : {&result.profile, &result.bore}) {
        p->z_start_mm = -(p->z_start_mm + p->step_mm * static_cast<double>(p->size()));
        for (auto* values : {&p->radius_mm, &p->slope, &p->sigma_mm, &p->points})
            std::reverse(values->begin(), values->end());
        for (double& slope : p->slope) slope = -slope;
    }
    std::reverse(result.rough_mm.begin(), result.rough_mm.end());
    const Eigen::Vector3d turn(1, -1, -1);  // exactly, not by way of sin π
    result.axis_T_scan.matrix().topRows<3>() = turn.asDiagonal() * fit.axis_T_scan.matrix().topRows<3>();
    // y and the slope along x change their sign
    const Eigen::Vector4d signs(1, -1, -1, 1);
    result.covariance = signs.asDiagonal() * fit.covariance * signs.asDiagonal();
    return result;
}

bool isBodyOfRevolution(const RevolutionFit& fit)
{
    return fit.not_turned == NotTurned::No;
}

}  // namespace lathelier::registration
