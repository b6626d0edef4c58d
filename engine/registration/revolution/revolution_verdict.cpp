#include "engine/registration/revolution/revolution_verdict.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/registration/revolution/quick_turn.h"
#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

/// What a body of revolution is, and why others are none (README, "Thresholds").
struct RevolutionThresholds {
    double least_consistent_share = 0.8;  ///< of the points, on one surface of revolution
    double least_side_share = 0.03;       ///< of the points, where the profile determines the axis across
    double largest_tilt = 0.01;           ///< standard uncertainty of the axis' direction, rad
    double noisy_sigmas = 3;              ///< a scatter whose multiple is above the next share is tested for its tails
    double noisy_share = 0.02;            ///< of the largest radius
    double tail_sigmas = 1.3;             ///< 19 % of normal values lie beyond,
    double least_tail_share = 0.1;        ///< and at least this share of the points has to, for noise
    double line_sigmas = 5;               ///< of the scatter: a cylinder of a smaller radius is a line of noise,
    double line_share = 0.1;              ///< when its second extent is below this share of the first
    double flat_noises = 3;               ///< of the noise between neighbours: a smaller extent is none,
    double flat_share = 0.005;            ///< nor is one below this share of the second extent
    double flat_line_share = 0.02;        ///< of the first extent: a flat part whose second is smaller is a line
    double sphere_extent_share = 0.3;     ///< of the first extent: the third one of a sphere
    double sphere_sigmas = 2;             ///< of scatter or noise: the points of a sphere lie that near to it,
    double sphere_share = 0.01;           ///< or within this share of the first extent
    std::size_t piece_part = 7;           ///< a group with more than this part (1 / n) of the points is a piece
    double cells_across = 40;             ///< by which pieces are told apart
    double on_profile_sigmas = 6;         ///< within that of the profile a point covers its sector
    std::size_t sector_points = 10;       ///< of the sample in each sector, on average
    std::size_t least_sectors = 12;
    std::size_t most_sectors = 144;
    double full_quantile = 0.98;   ///< of the points of the sectors: that of a full one
    double seen_share = 0.1;       ///< of a full sector: with fewer points they are spurious
    std::size_t bridged_deg = 10;  ///< gaps up to this are angular steps of the scanner, not occlusions
};
constexpr RevolutionThresholds revolutionThresholds{};

/// Points of the sample in each sector of the turn, and their distances from the profile; points far from it are left
/// out.
struct CoveredSectors {
    std::vector<double> counts;
    std::vector<double> errors_mm;
};

CoveredSectors coveredSectorsOf(const RevolutionFit& fit, const std::vector<Vector3d>& sample)
{
    const std::size_t sectors = std::clamp(sample.size() / revolutionThresholds.sector_points,
                                           revolutionThresholds.least_sectors, revolutionThresholds.most_sectors);
    CoveredSectors covered{std::vector<double>(sectors, 0), {}};
    for (const Vector3d& point : sample) {
        const Vector3d p = fit.axis_T_scan * point;
        const double place = (p.z() - fit.profile.z_start_mm) / fit.profile.step_mm;
        if (!(place >= 0) || place >= static_cast<double>(fit.profile.size())) continue;
        const auto bin = static_cast<std::size_t>(place);
        const double r = p.head<2>().norm();
        const double error =
            r - fit.profile.radius_mm[bin] - fit.profile.slope[bin] * (p.z() - fit.profile.middle_mm(bin));
        if (!(std::abs(error) < revolutionThresholds.on_profile_sigmas * fit.sigma_mm)) continue;
        covered.errors_mm.push_back(std::abs(error));
        covered.counts[sectorAbout(p.y(), p.x(), sectors)] += 1;
    }
    return covered;
}

/// Degrees of the circle with points on the profile; a sector with only a few, spurious ones, does not count.
double coverageOf(const std::vector<double>& counts)
{
    const std::size_t sectors = counts.size();
    std::vector<double> sorted = counts;
    const double full = quantileInPlace(sorted, revolutionThresholds.full_quantile);
    const std::size_t bridge = sectors * revolutionThresholds.bridged_deg / 360;
    std::vector<bool> seen(sectors);
    for (std::size_t k = 0; k < sectors; ++k) seen[k] = counts[k] > revolutionThresholds.seen_share * full;
    std::vector<bool> closed = seen;
    for (std::size_t k = 0; k < sectors; ++k) {
        if (!seen[k]) continue;
        std::size_t next = 1;
        while (next <= bridge + 1 && !seen[(k + next) % sectors]) ++next;
        if (next > bridge + 1) continue;
        for (std::size_t i = 1; i < next; ++i) closed[(k + i) % sectors] = true;
    }
    const auto count = std::count(closed.begin(), closed.end(), true);
    return 360.0 * static_cast<double>(count) / static_cast<double>(sectors);
}

/// A sphere through the points: all of them on it, and spread over it in all directions.
bool isSphere(const std::vector<Vector3d>& sample, const Vector3d& middle, const Vector3d& extents, double limit_mm)
{
    if (extents[0] < revolutionThresholds.sphere_extent_share * extents[2]) return false;
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Vector3d& point : sample) {  // |q|² = 2 c·q + (R² - c²)
        const Vector3d q = point - middle;
        const Eigen::Vector4d j(2 * q.x(), 2 * q.y(), 2 * q.z(), 1);
        normal += j * j.transpose();
        right += j * q.squaredNorm();
    }
    const Eigen::Vector4d solved = normal.ldlt().solve(right);
    const double square = solved[3] + solved.head<3>().squaredNorm();
    if (!(square > 0)) return false;
    std::vector<double> off;
    off.reserve(sample.size());
    for (const Vector3d& point : sample)
        off.push_back(std::abs((point - middle - solved.head<3>()).norm() - std::sqrt(square)));
    return off.empty() || madToSigma * upperMedianInPlace(off) < limit_mm;
}

/// Two or more groups, each with at least a seventh of the points, that no chain of neighbouring cells connects.
bool isInPieces(const std::vector<Vector3d>& sample)
{
    Vector3d low = sample.front(), high = sample.front();
    for (const Vector3d& p : sample) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double cell = (high - low).maxCoeff() / revolutionThresholds.cells_across;
    if (!(cell > 0)) return false;
    using Key = std::array<int, 3>;
    std::map<Key, std::size_t> cells;
    for (const Vector3d& p : sample) {
        const Vector3d place = (p - low) / cell;
        ++cells[{static_cast<int>(place.x()), static_cast<int>(place.y()), static_cast<int>(place.z())}];
    }
    int large = 0;
    while (!cells.empty()) {
        std::vector<Key> open{cells.begin()->first};
        std::size_t points = cells.begin()->second;
        cells.erase(cells.begin());
        while (!open.empty()) {
            const Key at = open.back();
            open.pop_back();
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dz = -1; dz <= 1; ++dz)
                        if (const auto found = cells.find({at[0] + dx, at[1] + dy, at[2] + dz}); found != cells.end()) {
                            points += found->second;
                            open.push_back(found->first);
                            cells.erase(found);
                        }
        }
        if (points > sample.size() / revolutionThresholds.piece_part) ++large;
    }
    return large >= 2;
}

/// Middle of the points, and their standard deviations along the principal axes in rising order.
struct PrincipalExtents {
    Vector3d middle = Vector3d::Zero();
    Vector3d extents = Vector3d::Zero();
};

PrincipalExtents principalExtentsOf(const std::vector<Vector3d>& sample)
{
    const auto count = static_cast<double>(sample.size());
    PrincipalExtents found;
    for (const Vector3d& p : sample) found.middle += p / count;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : sample) scatter += (p - found.middle) * (p - found.middle).transpose();
    found.extents =
        (Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues().cwiseMax(0.0) / count).cwiseSqrt();
    return found;
}

/// A line of noise is a perfect cylinder of a radius little larger than its scatter; a box, whose radii scatter as much
/// about any axis, is no line.
bool isLineOfNoise(const RevolutionFit& fit, const Vector3d& extents)
{
    if (!(extents[1] < revolutionThresholds.line_share * extents[2])) return false;
    std::vector<double> radii;
    for (const double r : fit.profile.radius_mm)
        if (!std::isnan(r)) radii.push_back(r);
    return !radii.empty() && upperMedianInPlace(radii) < revolutionThresholds.line_sigmas * fit.sigma_mm;
}

/// Whether axis and scatter are those of a body of revolution. `errors_mm`: distances of the points from the profile.
bool isTurned(const RevolutionFit& fit, const std::vector<double>& errors_mm)
{
    const double tilt = std::sqrt(fit.covariance(2, 2) + fit.covariance(3, 3));
    if (!fit.converged || !(fit.consistent_share >= revolutionThresholds.least_consistent_share) ||
        !(fit.side_share >= revolutionThresholds.least_side_share) || !(tilt < revolutionThresholds.largest_tilt))
        return false;
    if (!(revolutionThresholds.noisy_sigmas * fit.sigma_mm >
          revolutionThresholds.noisy_share * fit.profile.largestRadius_mm()))
        return true;
    // A larger scatter is accepted as noise only with the tails of a normal distribution.
    const auto far = std::count_if(errors_mm.begin(), errors_mm.end(),
                                   [&](double e) { return e > revolutionThresholds.tail_sigmas * fit.sigma_mm; });
    return static_cast<double>(far) > revolutionThresholds.least_tail_share * static_cast<double>(errors_mm.size());
}

/// What points that are no body of revolution are.
NotTurned otherShapeOf(const std::vector<Vector3d>& sample, const PrincipalExtents& principal, double noise_mm)
{
    const Vector3d& extents = principal.extents;
    if (extents[0] <
        std::max(revolutionThresholds.flat_noises * noise_mm, revolutionThresholds.flat_share * extents[1]))
        return extents[1] < revolutionThresholds.flat_line_share * extents[2] ? NotTurned::Line : NotTurned::Flat;
    if (isInPieces(sample)) return NotTurned::SeveralParts;
    const double limit_mm =
        std::max(revolutionThresholds.sphere_sigmas * noise_mm, revolutionThresholds.sphere_share * extents[2]);
    return isSphere(sample, principal.middle, extents, limit_mm) ? NotTurned::NoSingleAxis : NotTurned::NotRound;
}

}  // namespace

NotTurned judgeRevolution(RevolutionFit& fit, const std::vector<Vector3d>& sample, double noise_mm)
{
    const PrincipalExtents principal = principalExtentsOf(sample);
    const auto& radii = fit.profile.radius_mm;
    CoveredSectors covered;
    if (std::any_of(radii.begin(), radii.end(), [](double r) { return !std::isnan(r); })) {
        covered = coveredSectorsOf(fit, sample);
        fit.coverage_deg = coverageOf(covered.counts);
    }
    if (isLineOfNoise(fit, principal.extents)) return NotTurned::Line;
    const bool turned = isTurned(fit, covered.errors_mm);
    if (turned &&
        isSphere(sample, principal.middle, principal.extents, revolutionThresholds.sphere_sigmas * fit.sigma_mm))
        return NotTurned::NoSingleAxis;
    if (turned && fit.coverage_deg < leastCoverage_deg) return NotTurned::SmallCoverage;
    if (fit.bend.isLarge()) return NotTurned::Bent;
    return turned ? NotTurned::No : otherShapeOf(sample, principal, noise_mm);
}

}  // namespace lathelier::registration
