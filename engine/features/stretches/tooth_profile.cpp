#include "engine/features/stretches/tooth_profile.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

std::size_t phaseBin(double phase, std::size_t bins)
{
    return std::min(bins - 1, static_cast<std::size_t>(phase * static_cast<double>(bins)));
}

}  // namespace

double explainedBy(const StretchPoints& points, const SectionShape& shape)
{
    const std::size_t bins = stretchProof.fold_bins;
    std::vector<double> n(bins, 0), sum(bins, 0);
    double mean = 0, squares = 0;
    for (const double r : points.r_mm) mean += r / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t bin = phaseBin(shape.pitchPhase(points.turn[i], points.z_mm[i]), bins);
        const double off = points.r_mm[i] - mean;
        n[bin] += 1;
        sum[bin] += off;
        squares += off * off;
    }
    double between = 0;
    for (std::size_t b = 0; b < bins; ++b)
        if (n[b] > 0) between += sum[b] * sum[b] / n[b];
    return squares > 0 ? between / squares : 0;
}

std::size_t PitchProfile::binOf(const SectionShape& shape, double turn, double z_mm) const
{
    return phaseBin(shape.pitchPhase(turn, z_mm), size());
}

std::optional<PitchProfile> pitchProfile(const StretchPoints& points, const SectionShape& shape)
{
    const auto wanted = static_cast<std::size_t>(static_cast<double>(points.size()) / stretchProof.points_per_bin);
    const std::size_t bins = std::clamp(wanted, stretchProof.least_pitch_bins, stretchProof.pitch_bins);
    std::vector<std::vector<double>> radii(bins);
    for (std::size_t i = 0; i < points.size(); ++i)
        radii[phaseBin(shape.pitchPhase(points.turn[i], points.z_mm[i]), bins)].push_back(points.r_mm[i]);
    PitchProfile profile;
    for (std::vector<double>& own : radii) {
        if (own.empty()) return std::nullopt;
        const double middle = upperMedianInPlace(own);
        for (double& r : own) r = std::abs(r - middle);
        profile.radius_mm.push_back(middle);
        profile.scatter_mm.push_back(madToSigma * upperMedianInPlace(own));
    }
    return profile;
}

ToothLevels levelsOf(const PitchProfile& profile)
{
    std::vector<double> sorted = profile.radius_mm;
    ToothLevels levels;
    levels.root_mm = lowerQuantileInPlace(sorted, stretchProof.level_share);
    levels.crest_mm = lowerQuantileInPlace(sorted, 1 - stretchProof.level_share);
    return levels;
}

bool isOneTooth(const PitchProfile& profile, const ToothLevels& levels)
{
    std::size_t rises = 0;
    for (std::size_t b = 0; b < profile.size(); ++b)
        if (profile.radius_mm[b] < levels.middle_mm() &&
            profile.radius_mm[(b + 1) % profile.size()] >= levels.middle_mm())
            ++rises;
    return rises == 1;
}

double toothMiddle(const PitchProfile& profile, const ToothLevels& levels)
{
    std::complex<double> sum = 0;
    const auto bins = static_cast<double>(profile.size());
    for (std::size_t b = 0; b < profile.size(); ++b)
        if (profile.radius_mm[b] >= levels.middle_mm())
            sum += std::polar(1.0, turn_rad * (static_cast<double>(b) + 0.5) / bins);
    const double turn = std::arg(sum) / turn_rad;
    return turn - std::floor(turn);
}

std::vector<double> steadyRadii(const PitchProfile& profile, double sigma_mm)
{
    const std::size_t bins = profile.size();
    const auto within = [&](double largest_rise_mm) {
        std::vector<double> radii = profile.radius_mm;
        for (std::size_t b = 0; b < bins; ++b) {
            const double rise = profile.radius_mm[(b + 1) % bins] - profile.radius_mm[(b + bins - 1) % bins];
            if (profile.scatter_mm[b] > stretchProof.scattered_sigmas * sigma_mm + stretchProof.on_mm ||
                std::abs(rise) > largest_rise_mm)
                radii[b] = std::numeric_limits<double>::quiet_NaN();
        }
        return radii;
    };
    std::vector<double> level = within(stretchProof.rise_sigmas * sigma_mm + stretchProof.rise_mm);
    const auto flanks = std::count_if(level.begin(), level.end(), [](double r) { return std::isnan(r); });
    const double share = 1 - static_cast<double>(flanks) / static_cast<double>(bins);
    return share < stretchProof.least_level_share ? within(std::numeric_limits<double>::infinity()) : level;
}

}  // namespace lathelier::features
