#include "engine/registration/revolution/revolution_axis.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/drawn_places.h"
#include "engine/registration/point_tasks.h"
#include "engine/registration/revolution/face_bins.h"
#include "engine/registration/revolution/meridian_bins.h"
#include "engine/registration/revolution/meridian_share.h"
#include "engine/registration/revolution/revolution_guess.h"
#include "engine/registration/revolution/revolution_step.h"
#include "engine/registration/revolution/revolution_verdict.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

/// Samples, bins and ends of the stages of the fit (README, "Thresholds").
struct AxisFitThresholds {
    std::size_t guess_points = 12000;        ///< sample that the starts are tried on
    std::size_t coarse_points = 60000;       ///< sample of the bend and of the first steps
    std::size_t most_first_points = 200000;  ///< of a sample that the axis is fitted to first
    std::size_t most_points = 2000000;       ///< of the final fit of axis and radii
    std::uint64_t sample_seed = 11;          ///< of the draws, the same for every scan
    int trial_bins = 200;                    ///< along the part, while starts are tried
    int trial_steps = 4;                     ///< of the fit from each start
    int most_trials = 4;                     ///< starts that are tried
    double sure_consistent_share = 0.93;     ///< of the points: a start with more is taken without trying the next
    double sure_share_on_bins = 0.6;         ///< and with more of these
    double round_noises = 3;                 ///< of the noise between neighbours: sections that scatter less are round,
    double round_share = 0.005;              ///< and those that scatter less than this share of the radius
    int coarse_bins = 400;                   ///< along the part, for the bend and the first steps
    int coarse_steps = 3;                    ///< of the fit on the sample
    int finest_bins = 1000;                  ///< along the part
    int fewer_bins = 700;                    ///< the next number, where the rows of the scan leave bins empty,
    int fewest_bins = 80;                    ///< and so on times 0.7 down to this
    double filled_share = 0.1;               ///< of the median over the bins: with fewer points a bin counts as empty
    int least_runs = 3;                      ///< of filled bins, with more of which bins are finer than the rows,
    int bins_per_run = 20;                   ///< when the runs are shorter than this on average
    int most_steps = 14;                     ///< of the fit on the first points
    int slope_steps = 6;          ///< slopes near the noise switch on and off with every step: fixed after these
    double settled_sigmas = 0.1;  ///< a step below this is the last; each shrinks at least tenfold
};
constexpr AxisFitThresholds axisFit{};

/// `count` points spread over the whole cloud.
std::vector<Vector3d> samplePoints(const std::vector<Vector3d>& points, std::size_t count)
{
    if (points.size() <= count) return points;
    std::vector<Vector3d> sample;
    sample.reserve(count);
    for (const std::size_t place : drawnPlaces(points.size(), count, axisFit.sample_seed))
        sample.push_back(points[place]);
    return sample;
}

/// A start with its score on a small sample.
struct PoseTrial {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    MeridianBins bins;
    double consistent = -1;  ///< share of the points on one surface of revolution; -1: the axis is not determined
    double on_bins = -1;     ///< share of the points on bins that count

    /// Score of a trial: the consistent share of the points times the share on active bins. The former alone is too
    /// tolerant of wide bins, the latter alone rejects a part that is mostly thread and knurl.
    double score() const { return consistent < 0 ? -1 : consistent * on_bins; }
};

PoseTrial tryCandidate(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& pose, double noise_mm,
                       const Progress& progress)
{
    PoseTrial trial{pose, makeBins(sample, pose, axisFit.trial_bins)};
    for (int i = 0; i < axisFit.trial_steps; ++i) {
        if (!improve(sample, trial.pose, trial.bins, progress).determined) return trial;
        trial.bins = makeBins(sample, trial.pose, axisFit.trial_bins);
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
    const double least = axisFit.filled_share * upperMedianInPlace(counts);
    int runs = 0;
    int filled = 0;
    bool previous = false;
    for (int i = 0; i < bins.side_count; ++i) {
        const bool here = bins.bins[static_cast<std::size_t>(i)].points > least;
        if (here) ++filled;
        if (here && !previous) ++runs;
        previous = here;
    }
    return runs > std::max(axisFit.least_runs, filled / axisFit.bins_per_run);
}

/// The finest bins that are all filled by the rows of the scan.
MeridianBins makeFinestBins(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& pose)
{
    MeridianBins bins = makeBins(sample, pose, axisFit.finest_bins);
    for (int count = axisFit.fewer_bins; count >= axisFit.fewest_bins && isFinerThanRows(bins); count = count * 7 / 10)
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
    parallelFor(points.size(), taskPoints, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = bend.straightened(points[i]);
    });
    return result;
}

/// The stages of one fit.
class AxisFitting {
public:
    AxisFitting(const std::vector<Vector3d>& points, const Progress& progress) : points_(points), progress_(progress) {}

    RevolutionFit run()
    {
        sample_ = samplePoints(points_, axisFit.coarse_points);
        const bool is_fitted = findStart() && subtractBend() && approach() && settle();
        if (is_fitted) {
            describe();
        } else {
            fit_.axis_T_scan = best_.pose;
            fit_.sigma_mm = best_.bins.sigma_mm;
        }
        fit_.not_turned = judgeRevolution(fit_, sample_, noise_mm_);
        if (is_fitted) progress_.report(1);
        return fit_;
    }

private:
    /// The best of the first few candidates. False: none determines an axis.
    bool findStart()
    {
        const std::vector<Vector3d> small = samplePoints(points_, axisFit.guess_points);
        const AxisCandidates candidates = findAxisCandidates(small, progress_);
        noise_mm_ = candidates.noise_mm;
        std::vector<PoseTrial> trials;
        int tried = 0;
        for (const Eigen::Isometry3d& candidate : candidates.axis_T_scan) {
            PoseTrial trial = tryCandidate(small, candidate, noise_mm_, progress_);
            if (!isSure(trial)) trial = betterStraightened(small, candidate, std::move(trial));
            if (trial.score() > best_.score()) best_ = trial;
            trials.push_back(trial);
            if (isSure(best_) || ++tried == axisFit.most_trials) break;
        }
        if (best_.consistent < 0) return false;
        progress_.report(0.3);
        round_mm_ = std::max(axisFit.round_noises * noise_mm_, axisFit.round_share * best_.bins.largest_mm);
        if (best_.consistent <= axisFit.sure_consistent_share) preferRoundSections(small, trials);
        return true;
    }

    static bool isSure(const PoseTrial& trial)
    {
        return trial.consistent > axisFit.sure_consistent_share && trial.on_bins > axisFit.sure_share_on_bins;
    }

    /// The trial on points without their bend, where that scores better: of a bent bar the radii scatter so much that
    /// no bin counts, or only those where the bend crosses the axis.
    PoseTrial betterStraightened(const std::vector<Vector3d>& small, const Eigen::Isometry3d& pose,
                                 PoseTrial trial) const
    {
        const Bend bend = findBend(small, pose, makeBins(small, pose, axisFit.trial_bins));
        const double round_mm = std::max(axisFit.round_noises * noise_mm_, axisFit.round_share * trial.bins.largest_mm);
        if (!bend.isSeen() || bend.scatter_mm > round_mm) return trial;
        PoseTrial straight = tryCandidate(straightened(small, bend, progress_), pose, noise_mm_, progress_);
        return straight.score() > trial.score() ? straight : trial;
    }

    /// With a strong bend all trials score badly; the one with round sections is right.
    void preferRoundSections(const std::vector<Vector3d>& small, const std::vector<PoseTrial>& trials)
    {
        for (const PoseTrial& trial : trials) {
            if (trial.consistent < 0) continue;
            const Bend own = findBend(small, trial.pose, trial.bins);
            if (!own.isSeen() || own.scatter_mm > round_mm_) continue;
            best_ = trial;
            break;
        }
    }

    /// A bend is subtracted from the points in iterations, since the radii of the first are those of the bent part: a
    /// parabola twice, then what is left of its shape.
    /// Not done where the sections are not round, because their centres are not defined. False: the bend is large.
    bool subtractBend()
    {
        pose_ = best_.pose;
        Bend bend = findBend(sample_, pose_, makeBins(sample_, pose_, axisFit.coarse_bins));
        if (!bend.isSeen() || !(bend.scatter_mm < round_mm_)) return true;
        const std::vector<Vector3d> first = straightened(sample_, bend, progress_);
        bend = Bend::sum(bend, findBend(first, pose_, makeBins(first, pose_, axisFit.coarse_bins)));
        if (!bend.isSeen()) return true;
        const std::vector<Vector3d> second = straightened(sample_, bend, progress_);
        bend =
            Bend::sum(bend, findBend(second, pose_, makeBins(second, pose_, axisFit.coarse_bins), BendShape::Quartic));
        fit_.bend = bend;
        if (bend.isLarge()) return false;
        sample_ = straightened(sample_, bend, progress_);
        return true;
    }

    /// The first steps, on the sample, and the finest bins. False: the points do not determine the axis.
    bool approach()
    {
        for (int i = 0; i < axisFit.coarse_steps; ++i) {
            bins_ = makeBins(sample_, pose_, axisFit.coarse_bins);
            if (!improve(sample_, pose_, bins_, progress_).determined) return false;
            ++fit_.iterations;
        }
        bins_ = makeFinestBins(sample_, pose_);
        fit_.consistent_share = consistentShare(sample_, pose_, bins_, noise_mm_);
        progress_.report(0.5);
        return true;
    }

    /// The last steps, on an even part of a large cloud until they are far below the uncertainty, then on all points.
    /// False: the points do not determine the axis.
    bool settle()
    {
        std::vector<Vector3d> chosen;
        if (points_.size() > axisFit.most_points) chosen = samplePoints(points_, axisFit.most_points);
        if (fit_.bend.isSeen()) chosen = straightened(chosen.empty() ? points_ : chosen, fit_.bend, progress_);
        const std::vector<Vector3d>& all = chosen.empty() ? points_ : chosen;
        const std::vector<Vector3d> fewer = all.size() > axisFit.most_first_points
                                                ? samplePoints(all, axisFit.most_first_points)
                                                : std::vector<Vector3d>{};
        for (int i = 0; i < axisFit.most_steps && !fit_.converged; ++i) {
            if (!takeStep(fewer.empty() ? all : fewer)) return false;
            const double relative =
                std::sqrt(step_.change.dot(step_.hessian * step_.change));  // in standard uncertainties
            fit_.converged = relative < axisFit.settled_sigmas;
            if (!fit_.converged && i < axisFit.slope_steps) refineSlopes(bins_);
            progress_.report(0.5 + 0.1 * std::min(i, 4));
        }
        if (!fewer.empty() && !takeStep(all)) return false;
        fit_.side_share = step_.sums.side_weights / static_cast<double>(all.size());
        fit_.covariance = covarianceOf(all, pose_, bins_, step_, progress_);
        return true;
    }

    bool takeStep(const std::vector<Vector3d>& points)
    {
        step_ = improve(points, pose_, bins_, progress_);
        ++fit_.iterations;
        return step_.determined;
    }

    /// Profiles and scatter of the settled fit.
    void describe()
    {
        fit_.axis_T_scan = pose_;
        fit_.sigma_mm = bins_.sigma_mm;
        fit_.profile = radiusProfileOf(bins_, step_.sums.bins, 0);
        clearFaceBins(fit_.profile, fit_.sigma_mm);
        if (bins_.wall_count > bins_.side_count) fit_.bore = radiusProfileOf(bins_, step_.sums.bins, bins_.side_count);
        const std::vector<bool> rough = roughBins(sample_, pose_, bins_);
        for (std::size_t i = 0; i < rough.size(); ++i)
            fit_.rough_mm.push_back(rough[i] ? bins_.bins[i].value : notANumber);
        clearRoughFaceBins(fit_.rough_mm, fit_.profile, fit_.sigma_mm);
    }

    const std::vector<Vector3d>& points_;
    const Progress& progress_;
    RevolutionFit fit_;
    PoseTrial best_;
    std::vector<Vector3d> sample_;  ///< without the bend, once that is found
    Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
    MeridianBins bins_;
    Step step_;
    double noise_mm_ = 0;  ///< between neighbours
    double round_mm_ = 0;  ///< largest scatter of a round section
};

}  // namespace

RevolutionFit fitRevolution(const std::vector<Vector3d>& points, const Progress& progress)
{
    return AxisFitting(points, progress).run();
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
