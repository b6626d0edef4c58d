#include "engine/features/stretches/spline_fit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/stretches/stretch_limits.h"
#include "engine/features/stretches/tooth_profile.h"

namespace lathelier::features {
namespace {

SectionShape teethShape(std::size_t teeth)
{
    SectionShape shape;
    shape.count = teeth;
    return shape;
}

/// The number of teeth, and what its profile explains.
std::pair<std::size_t, double> teethOf(const StretchPoints& points)
{
    std::vector<double> explained;
    double best = 0;
    for (int teeth = stretchProof.least_teeth; teeth <= stretchProof.most_teeth; ++teeth) {
        explained.push_back(explainedBy(points, teethShape(static_cast<std::size_t>(teeth))));
        best = std::max(best, explained.back());
    }
    std::size_t index = explained.size() - 1;
    while (index > 0 && explained[index] < best - stretchProof.as_good) --index;
    return {index + static_cast<std::size_t>(stretchProof.least_teeth), explained[index]};
}

/// Is there one tooth a pitch, deep enough, that is no wave of form?
bool isTooth(const PitchProfile& profile, const ToothLevels& levels, std::size_t teeth, double sigma_mm)
{
    if (levels.depth_mm() < std::max(stretchProof.least_depth_mm, stretchProof.least_depth_sigmas * sigma_mm))
        return false;
    const std::size_t bins = profile.size();
    double mean = 0, squares = 0, between = 0;
    const double margin_mm = stretchProof.between_level * levels.depth_mm();
    for (const double r : profile.radius_mm) mean += r / static_cast<double>(bins);
    std::complex<double> wave = 0;
    for (std::size_t b = 0; b < bins; ++b) {
        const double now = profile.radius_mm[b];
        if (now > levels.root_mm + margin_mm && now < levels.crest_mm - margin_mm) between += 1;
        squares += (now - mean) * (now - mean);
        wave += (now - mean) * std::polar(1.0, -turn_rad * static_cast<double>(b) / static_cast<double>(bins));
    }
    const double share = 2 * std::norm(wave) / (static_cast<double>(bins) * squares);
    // A fine knurl is a wave of ridges; fine teeth have levels.
    const bool has_levels = between < stretchProof.most_between_share * static_cast<double>(bins);
    const double pitch_mm = turn_rad * levels.crest_mm / static_cast<double>(teeth);
    const bool is_deep = levels.depth_mm() > stretchProof.deep_share * pitch_mm;
    if (!has_levels && (teeth < stretchProof.few_teeth || pitch_mm < stretchProof.least_pitch_mm)) return false;
    return isOneTooth(profile, levels) && (is_deep || share < stretchProof.wave_share);
}

/// Median of the points on one level, tooth by tooth, and of all.
struct LevelOfTeeth {
    double radius_mm = 0, sigma_mm = 0;  ///< of all, standard uncertainty from the scatter of the teeth
    bool are_alike = false;
};

LevelOfTeeth levelOfTeeth(const StretchPoints& points, const SectionShape& shape, const PitchProfile& profile,
                          double level_mm, double depth_mm)
{
    std::vector<std::vector<double>> own(shape.count);
    std::vector<double> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double radius = profile.radius_mm[profile.binOf(shape, points.turn[i], points.z_mm[i])];
        if (std::abs(radius - level_mm) > points.onShape_mm()) continue;
        const double place = points.turn[i] - shape.phase_turn + 0.5 / static_cast<double>(shape.count);
        const auto tooth = static_cast<std::size_t>((place - std::floor(place)) * static_cast<double>(shape.count));
        own[std::min(tooth, shape.count - 1)].push_back(points.r_mm[i]);
        all.push_back(points.r_mm[i]);
    }
    LevelOfTeeth level;
    if (all.empty()) return level;
    level.radius_mm = upperMedianInPlace(all);
    double squares = 0;
    for (std::vector<double>& radii : own) {
        if (radii.size() < stretchProof.least_face_points / 4) return level;
        const double off = upperMedianInPlace(radii) - level.radius_mm;
        if (std::abs(off) > stretchProof.odd_tooth_share * depth_mm) return level;
        squares += off * off;
    }
    const auto n = static_cast<double>(shape.count);
    level.sigma_mm = std::hypot(std::sqrt(squares / (n * (n - 1))), stretchProof.form_mm);
    level.are_alike = true;
    return level;
}

/// Width between parallel flanks 2 r sin φ, φ from the middle of the tooth: rays see such flanks between the levels.
std::optional<double> parallelWidth_mm(const StretchPoints& points, const SectionShape& shape,
                                       const ToothLevels& levels)
{
    std::vector<double> widths, low, high, offs;
    const double margin = stretchProof.flank_sigmas * points.sigma_mm + stretchProof.on_mm;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points.r_mm[i] < levels.root_mm + margin || points.r_mm[i] > levels.crest_mm - margin) continue;
        widths.push_back(2 * points.r_mm[i] * std::abs(std::sin(shape.faceAngle(points.turn[i]))));
        (points.r_mm[i] < levels.middle_mm() ? low : high).push_back(widths.back());
    }
    const double least = stretchProof.least_flank_share * static_cast<double>(points.size()) / 2;
    if (static_cast<double>(std::min(low.size(), high.size())) < least) return std::nullopt;
    const double width = medianInPlace(widths);
    for (const double one : widths) offs.push_back(std::abs(one - width));
    const double scatter = madToSigma * upperMedianInPlace(offs);
    const double limit = stretchProof.flank_scatter_sigmas * points.sigma_mm + stretchProof.flank_scatter_mm;
    // Half of the depth lies between the middles of the two halves.
    const double radial = width * levels.depth_mm() / (2 * levels.middle_mm());
    const bool is_parallel = std::abs(medianInPlace(high) - medianInPlace(low)) < stretchProof.slope_share * radial;
    return is_parallel && scatter < limit ? std::optional(width) : std::nullopt;
}

}  // namespace

std::optional<FoundShape> splineOf(const StretchPoints& points)
{
    const auto [teeth, explained] = teethOf(points);
    if (explained < stretchProof.least_explained) return std::nullopt;
    SectionShape shape = teethShape(teeth);
    shape.kind = MarkKind::Spline;
    const auto first = pitchProfile(points, shape);
    if (!first) return std::nullopt;
    const ToothLevels levels = levelsOf(*first);
    if (!isTooth(*first, levels, teeth, points.sigma_mm)) return std::nullopt;
    shape.phase_turn = toothMiddle(*first, levels) / static_cast<double>(teeth);
    const auto profile = pitchProfile(points, shape);
    if (!profile) return std::nullopt;
    const double depth = levels.depth_mm();
    const LevelOfTeeth crest = levelOfTeeth(points, shape, *profile, levels.crest_mm, depth),
                       root = levelOfTeeth(points, shape, *profile, levels.root_mm, depth);
    if (!crest.are_alike || root.radius_mm <= 0) return std::nullopt;
    shape.level_mm = crest.radius_mm;
    shape.pitch_mm = steadyRadii(*profile, points.sigma_mm);
    FoundShape found{shape, {}};
    found.mark.kind = MarkKind::Spline;
    found.mark.teeth = static_cast<double>(teeth);
    found.mark.major_mm = 2 * crest.radius_mm;
    found.mark.minor_mm = 2 * root.radius_mm;
    found.mark.width_mm = parallelWidth_mm(points, shape, {root.radius_mm, crest.radius_mm});
    found.mark.angle_deg = markAngle_deg(shape.phase_turn);
    found.mark.uncertainty_mm = 4 * crest.sigma_mm;  // k = 2, of a diameter
    if (root.are_alike) found.mark.depth_uncertainty_mm = 4 * root.sigma_mm;
    return found;
}

}  // namespace lathelier::features
