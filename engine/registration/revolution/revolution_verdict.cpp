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

/// Degrees of the circle with points on the profile; a sector with only a few, spurious ones, does not count.
double coverageOf(const RevolutionFit& fit, const std::vector<Vector3d>& sample, std::vector<double>& errors)
{
    const std::size_t sectors = std::clamp<std::size_t>(sample.size() / 10, 12, 144);
    std::vector<double> counts(sectors, 0);
    for (const Vector3d& point : sample) {
        const Vector3d p = fit.axis_T_scan * point;
        const double place = (p.z() - fit.profile.z_start_mm) / fit.profile.step_mm;
        if (!(place >= 0) || place >= static_cast<double>(fit.profile.size())) continue;
        const auto bin = static_cast<std::size_t>(place);
        const double r = p.head<2>().norm();
        const double error =
            r - fit.profile.radius_mm[bin] - fit.profile.slope[bin] * (p.z() - fit.profile.middle_mm(bin));
        if (!(std::abs(error) < 6 * fit.sigma_mm)) continue;
        errors.push_back(std::abs(error));
        const double turn = quickTurn(p.y(), p.x()) + 0.5;
        counts[std::min(sectors - 1, static_cast<std::size_t>(turn * static_cast<double>(sectors)))] += 1;
    }
    std::vector<double> sorted = counts;
    std::sort(sorted.begin(), sorted.end());
    const double most = sorted[sorted.size() * 49 / 50];
    // Gaps of up to 10° are angular steps of the scanner, not occlusions.
    const std::size_t bridge = sectors * 10 / 360;
    std::vector<bool> seen(sectors);
    for (std::size_t k = 0; k < sectors; ++k) seen[k] = counts[k] > 0.1 * most;
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
    if (extents[0] < 0.3 * extents[2]) return false;
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
    return off.empty() || 1.4826 * upperMedianInPlace(off) < limit_mm;
}

/// Two or more groups, each with at least a seventh of the points, that no chain of neighbouring cells connects.
bool isInPieces(const std::vector<Vector3d>& sample)
{
    Vector3d low = sample.front(), high = sample.front();
    for (const Vector3d& p : sample) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double cell = (high - low).maxCoeff() / 40;
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
        if (points > sample.size() / 7) ++large;
    }
    return large >= 2;
}

}  // namespace

NotTurned judgeRevolution(RevolutionFit& fit, const std::vector<Vector3d>& sample, double noise_mm)
{
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : sample) middle += p / static_cast<double>(sample.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : sample) scatter += (p - middle) * (p - middle).transpose();
    const Vector3d extents = (Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues().cwiseMax(0.0) /
                              static_cast<double>(sample.size()))
                                 .cwiseSqrt();
    double largest = 0;
    std::vector<double> radii;
    for (const double r : fit.profile.radius_mm)
        if (!std::isnan(r)) {
            largest = std::max(largest, r);
            radii.push_back(r);
        }
    std::vector<double> errors;
    if (!radii.empty()) fit.coverage_deg = coverageOf(fit, sample, errors);

    // A line of noise is a perfect cylinder of a radius little larger than its scatter; a box, whose radii scatter as
    // much about any axis, is no line.
    const bool is_long = extents[1] < 0.1 * extents[2];
    if (is_long && !radii.empty() && upperMedianInPlace(radii) < 5 * fit.sigma_mm) return NotTurned::Line;
    const double tilt = std::sqrt(fit.covariance(2, 2) + fit.covariance(3, 3));
    bool turned = fit.converged && fit.consistent_share >= 0.8 && fit.side_share >= 0.03 && tilt < 0.01;
    if (turned && 3 * fit.sigma_mm > 0.02 * largest) {
        // A larger scatter is accepted as noise only with the tails of a normal distribution: 19 % beyond 1.3 sigma.
        const auto far = std::count_if(errors.begin(), errors.end(), [&](double e) { return e > 1.3 * fit.sigma_mm; });
        turned = static_cast<double>(far) > 0.1 * static_cast<double>(errors.size());
    }
    if (turned && isSphere(sample, middle, extents, 2 * fit.sigma_mm)) return NotTurned::NoSingleAxis;
    if (turned && fit.coverage_deg < leastCoverage_deg) return NotTurned::SmallCoverage;
    if (fit.bend.isLarge()) return NotTurned::Bent;
    if (turned) return NotTurned::No;

    if (extents[0] < std::max(3 * noise_mm, 0.005 * extents[1])) {
        return extents[1] < 0.02 * extents[2] ? NotTurned::Line : NotTurned::Flat;
    }
    if (isInPieces(sample)) return NotTurned::SeveralParts;
    if (isSphere(sample, middle, extents, std::max(2 * noise_mm, 0.01 * extents[2]))) return NotTurned::NoSingleAxis;
    return NotTurned::NotRound;
}

}  // namespace lathelier::registration
