#include "engine/registration/revolution_axis.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/registration/meridian_bins.h"

namespace lathelier {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr std::size_t kGuessPoints = 12000;
constexpr std::size_t kSamplePoints = 60000;
constexpr std::size_t kGrain = 16384;
constexpr double kTukey = 6;  // in standard deviations: 99 % efficient, and blind to what lies further off

/// Points spread over the whole cloud: one from each of `count` equal runs, at a drawn place, so that no grid of the
/// scanner is met in step.
std::vector<Vector3d> samplePoints(const std::vector<Vector3d>& points, std::size_t count)
{
    if (points.size() <= count) return points;
    std::vector<Vector3d> sample(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = (static_cast<double>(i) + randomUniform(11, 0, i)) * static_cast<double>(points.size());
        sample[i] = points[std::min(points.size() - 1, static_cast<std::size_t>(place / static_cast<double>(count)))];
    }
    return sample;
}

/// Sums of one pass: the normal equations of the four axis parameters (per unit variance), and for each bin what
/// eliminating its own free value takes.
struct Sums {
    Matrix4d hessian = Matrix4d::Zero();
    Vector4d gradient = Vector4d::Zero();
    double squares = 0;       ///< Σ w e²
    double weights = 0;       ///< Σ w
    double side_weights = 0;  ///< Σ w at the side
    struct Bin {
        double weight = 0;
        double error = 0;
        double square = 0;
        Vector4d jacobian = Vector4d::Zero();
    };
    std::vector<Bin> bins;

    void add(const Sums& other)
    {
        hessian += other.hessian;
        gradient += other.gradient;
        squares += other.squares;
        weights += other.weights;
        side_weights += other.side_weights;
        if (bins.size() < other.bins.size()) bins.resize(other.bins.size());
        for (std::size_t i = 0; i < other.bins.size(); ++i) {
            bins[i].weight += other.bins[i].weight;
            bins[i].error += other.bins[i].error;
            bins[i].square += other.bins[i].square;
            bins[i].jacobian += other.bins[i].jacobian;
        }
    }
};

void accumulate(const std::vector<Vector3d>& points, std::size_t begin, std::size_t end, const Eigen::Isometry3d& pose,
                const MeridianBins& bins, Sums& sums)
{
    sums.bins.resize(bins.bins.size());
    // The lower triangle by hand: this loop is where the time goes.
    double h[10] = {}, g[4] = {};
    for (std::size_t i = begin; i < end; ++i) {
        const Vector3d p = pose * points[i];
        const double r = std::sqrt(p.x() * p.x() + p.y() * p.y());
        const int key = bins.find(p.z(), r);
        if (key < 0 || r == 0) continue;
        const MeridianBin& bin = bins.bins[static_cast<std::size_t>(key)];
        const bool side = key < bins.side_count;
        const double along = side ? p.z() : r;
        const double across = side ? r : p.z();
        const double error = bin.cosine * (across - bin.value - bin.slope * (along - bin.middle));
        const double u = error / (kTukey * bin.sigma);
        if (!(u * u < 1)) continue;
        const double tukey = (1 - u * u) * (1 - u * u);
        const double w = tukey / (bin.sigma * bin.sigma);
        const double c = p.x() / r;
        const double s = p.y() / r;
        // A shift (x0, y0) and slopes (tx, ty) of the axis: dr = -c (x0 + tx z) - s (y0 + ty z), dz = r (c tx + s ty).
        const double to_r = side ? bin.cosine : -bin.cosine * bin.slope;
        const double to_z = side ? -bin.cosine * bin.slope : bin.cosine;
        const double tilt = to_z * r - to_r * p.z();
        const double j[4] = {-to_r * c, -to_r * s, tilt * c, tilt * s};
        const double we = w * error;
        int k = 0;
        for (int a = 0; a < 4; ++a) {
            const double wj = w * j[a];
            for (int b = 0; b <= a; ++b) h[k++] += wj * j[b];
            g[a] += we * j[a];
        }
        sums.squares += tukey * u * u;
        sums.weights += tukey;
        if (side && bin.cosine > 0.3) sums.side_weights += tukey;
        Sums::Bin& own = sums.bins[static_cast<std::size_t>(key)];
        own.weight += w;
        own.error += we;
        own.square += we * error;
        for (int a = 0; a < 4; ++a) own.jacobian[a] += w * j[a];
    }
    int k = 0;
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b <= a; ++b, ++k) {
            sums.hessian(a, b) += h[k];
            if (a != b) sums.hessian(b, a) += h[k];
        }
        sums.gradient[a] += g[a];
    }
}

struct Step {
    Vector4d change = Vector4d::Zero();
    Matrix4d hessian = Matrix4d::Zero();  ///< with the bins' values eliminated, per unit variance
    bool determined = false;
    Sums sums;
};

/// One Gauss-Newton step of axis and bins together. Moves the pose and the bins' values.
Step improve(const std::vector<Vector3d>& points, Eigen::Isometry3d& pose, MeridianBins& bins, const Progress& progress)
{
    Step step;
    step.sums = parallelReduce(
        points.size(), std::max(kGrain, points.size() / 24), progress, Sums{},
        [&](std::size_t begin, std::size_t end) {
            Sums part;
            accumulate(points, begin, end, pose, bins, part);
            return part;
        },
        [](Sums all, const Sums& part) {
            all.add(part);
            return all;
        });
    Vector4d gradient = step.sums.gradient;
    step.hessian = step.sums.hessian;
    for (const Sums::Bin& bin : step.sums.bins) {
        if (bin.weight <= 0) continue;
        step.hessian -= bin.jacobian * bin.jacobian.transpose() / bin.weight;
        gradient -= bin.jacobian * (bin.error / bin.weight);
    }
    // Only what is singular is given up here: on the way, an exact face may outweigh a rough side by ten decades.
    const double arm = bins.size_mm;
    const Vector4d unit(1, 1, 1 / arm, 1 / arm);
    const Matrix4d scaled = unit.asDiagonal() * step.hessian * unit.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(scaled);
    step.determined = eigen.eigenvalues()[0] > 1e-13 * eigen.eigenvalues()[3] && eigen.eigenvalues()[3] > 0;
    if (!step.determined) return step;
    step.change = -(unit.asDiagonal() * scaled.ldlt().solve(unit.asDiagonal() * gradient));
    step.determined = step.change.allFinite();
    if (!step.determined) return step;

    for (std::size_t i = 0; i < step.sums.bins.size(); ++i) {
        const Sums::Bin& bin = step.sums.bins[i];
        if (bin.weight > 0)
            bins.bins[i].value += (bin.error + bin.jacobian.dot(step.change)) / bin.weight / bins.bins[i].cosine;
    }
    const Vector3d direction = Vector3d(step.change[2], step.change[3], 1).normalized();
    Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
    // Rows that are orthonormal to the last bit; a quaternion of nearly equal vectors is so to 1e-8 only.
    const Vector3d across = (Vector3d::UnitX() - direction * direction.x()).normalized();
    move.linear() << across.transpose(), direction.cross(across).transpose(), direction.transpose();
    move.translation() = -(move.linear() * Vector3d(step.change[0], step.change[1], 0));
    pose = move * pose;
    return step;
}

/// A start and how good it turned out on a small sample.
struct Trial {
    Eigen::Isometry3d pose;
    MeridianBins bins;
    double consistent = -1;
};

Trial tryCandidate(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& pose, double noise_mm,
                   const Progress& progress)
{
    Trial trial{pose, makeBins(sample, pose, 200)};
    for (int i = 0; i < 4; ++i) {
        if (!improve(sample, trial.pose, trial.bins, progress).determined) return trial;
        trial.bins = makeBins(sample, trial.pose, 200);
    }
    trial.consistent = consistentShare(sample, trial.pose, trial.bins, noise_mm);
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
    const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
    std::nth_element(counts.begin(), middle, counts.end());
    const double least = 0.1 * *middle;
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

/// The finest bins, up to 1000 along the part, that the rows of the scan fill.
MeridianBins makeFinestBins(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& pose)
{
    MeridianBins bins = makeBins(sample, pose, 1000);
    for (int count = 700; count >= 80 && isFinerThanRows(bins); count = count * 7 / 10)
        bins = makeBins(sample, pose, count);
    return bins;
}

RadiusProfile profileOf(const MeridianBins& bins, const std::vector<Sums::Bin>& sums)
{
    RadiusProfile profile;
    profile.z_start_mm = bins.z_start_mm;
    profile.step_mm = bins.step_mm;
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < bins.side_count; ++i) {
        const MeridianBin& bin = bins.bins[static_cast<std::size_t>(i)];
        const Sums::Bin& sum = sums[static_cast<std::size_t>(i)];
        const bool known = bin.active && sum.weight > 0;
        profile.radius_mm.push_back(known ? bin.value : none);
        profile.slope.push_back(known ? bin.slope : none);
        profile.sigma_mm.push_back(known ? 1 / std::sqrt(sum.weight) / bin.cosine : none);
        profile.points.push_back(known ? sum.weight * bin.sigma * bin.sigma : 0);
    }
    return profile;
}

}  // namespace

RevolutionFit fitRevolution(const std::vector<Vector3d>& points, const Progress& progress)
{
    RevolutionFit fit;
    const std::vector<Vector3d> small = samplePoints(points, kGuessPoints);
    Trial best;
    int tried = 0;
    const AxisCandidates candidates = findAxisCandidates(small, progress);
    for (const Eigen::Isometry3d& candidate : candidates.axis_T_scan) {
        const Trial trial = tryCandidate(small, candidate, candidates.noise_mm, progress);
        if (trial.consistent > best.consistent) best = trial;
        if (best.consistent > 0.93 || ++tried == 4) break;
    }
    if (best.consistent < 0) return fit;
    progress.report(0.3);

    const std::vector<Vector3d> sample = samplePoints(points, kSamplePoints);
    Eigen::Isometry3d pose = best.pose;
    MeridianBins bins;
    for (int i = 0; i < 3; ++i) {
        bins = makeBins(sample, pose, 400);
        if (!improve(sample, pose, bins, progress).determined) return fit;
        ++fit.iterations;
    }
    bins = makeFinestBins(sample, pose);
    fit.consistent_share = consistentShare(sample, pose, bins, candidates.noise_mm);
    progress.report(0.5);

    // All points. The step shrinks tenfold or more each time; done when it was a tenth of the statistical uncertainty.
    Step step;
    for (int i = 0; i < 12 && !fit.converged; ++i) {
        step = improve(points, pose, bins, progress);
        ++fit.iterations;
        if (!step.determined) return fit;
        const double relative = std::sqrt(step.change.dot(step.hessian * step.change));  // in standard uncertainties
        fit.converged = relative < 0.1;
        if (!fit.converged) refineSlopes(bins);
        progress.report(0.5 + 0.1 * std::min(i, 4));
    }
    fit.axis_T_scan = pose;
    fit.sigma_mm = bins.sigma_mm;
    fit.side_share = step.sums.side_weights / static_cast<double>(points.size());
    fit.covariance = step.hessian.inverse();
    fit.profile = profileOf(bins, step.sums.bins);
    progress.report(1);
    return fit;
}

RevolutionFit reversed(const RevolutionFit& fit)
{
    RevolutionFit result = fit;
    RadiusProfile& p = result.profile;
    p.z_start_mm = -(p.z_start_mm + p.step_mm * static_cast<double>(p.size()));
    for (auto* values : {&p.radius_mm, &p.slope, &p.sigma_mm, &p.points}) std::reverse(values->begin(), values->end());
    for (double& slope : p.slope) slope = -slope;
    const Eigen::Vector3d turn(1, -1, -1);  // exactly, not by way of sin π
    result.axis_T_scan.matrix().topRows<3>() = turn.asDiagonal() * fit.axis_T_scan.matrix().topRows<3>();
    // y and the slope along x change their sign
    const Eigen::Vector4d signs(1, -1, -1, 1);
    result.covariance = signs.asDiagonal() * fit.covariance * signs.asDiagonal();
    return result;
}

bool isBodyOfRevolution(const RevolutionFit& fit)
{
    const double tilt = std::sqrt(fit.covariance(2, 2) + fit.covariance(3, 3));  // a sphere has no axis
    return fit.converged && fit.consistent_share >= 0.8 && fit.side_share >= 0.03 && tilt < 0.01;
}

}  // namespace lathelier
