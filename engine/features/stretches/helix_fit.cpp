#include "engine/features/stretches/helix_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/features/stretches/stretch_limits.h"
#include "engine/features/stretches/tooth_profile.h"
#include "engine/features/walls/crest.h"

namespace lathelier::features {
namespace {

/// Modules of DIN 780-1, series 1, as far as a pitch of the search.
constexpr std::array modules_mm{1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0};

StretchPoints thinnedPoints(const StretchPoints& points, std::size_t most)
{
    StretchPoints few;
    const std::size_t count = std::min(most, points.size());
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k * points.size() / count;
        few.z_mm.push_back(points.z_mm[i]);
        few.r_mm.push_back(points.r_mm[i]);
        few.turn.push_back(points.turn[i]);
    }
    return few;
}

/// A helix and what it explains.
struct FoundHelix {
    SectionShape shape;
    double explained = 0;
};

/// The best along a grid of pitches, then on ever finer ones.
FoundHelix bestPitch(const StretchPoints& few, std::size_t starts, double hand, double length_mm,
                     const Progress& progress)
{
    FoundHelix best;
    SectionShape shape;
    shape.kind = MarkKind::Thread;
    shape.count = starts;
    const auto consider = [&](double waves_per_mm) {
        shape.waves_per_mm = waves_per_mm;
        const double explained = explainedBy(few, shape);
        if (explained > best.explained) best = {shape, explained};
    };
    double step = 1 / (helixLimits.steps_per_wave * length_mm);
    for (double f = 1 / helixLimits.longest_pitch_mm; f < 1 / helixLimits.shortest_pitch_mm; f += step) {
        progress.check();
        consider(hand * f);
    }
    for (int round = 0; round < helixLimits.rounds && best.explained > 0; ++round) {
        step /= 2;
        const double middle = best.shape.waves_per_mm;
        consider(middle - step);
        consider(middle + step);
    }
    return best;
}

FoundHelix bestHelix(const StretchPoints& points, double length_mm, const Progress& progress)
{
    const StretchPoints few = thinnedPoints(points, helixLimits.search_points);
    FoundHelix best;
    for (std::size_t starts = 1; starts <= helixLimits.most_starts; ++starts)
        for (const double hand : {1.0, -1.0}) {
            const FoundHelix one = bestPitch(few, starts, hand, length_mm, progress);
            if (one.explained > best.explained - (starts > best.shape.count ? stretchProof.as_good : 0)) best = one;
        }
    return best;
}

/// Crest of the radii, as of any rough surface; the narrow crest of a thread is blurred. Second: standard uncertainty.
std::pair<double, double> crestOfHelix(const StretchPoints& points, double level_mm)
{
    std::vector<float> radii;
    radii.reserve(points.size());
    for (const double r : points.r_mm) radii.push_back(static_cast<float>(r));
    const std::optional<Crest> crest = crestOf(radii, points.sigma_mm);
    if (!crest || std::abs(crest->radius_mm - level_mm) > helixLimits.crest_mm) return {level_mm, points.onShape_mm()};
    const double blur = std::abs(crest->radius_mm - level_mm) / 2;
    return {crest->radius_mm, std::hypot(crest->sigma_mm, blur, stretchProof.form_mm)};
}

/// Median of the points on the level.
double rootOfHelix(const StretchPoints& points, const SectionShape& shape, const PitchProfile& profile, double level_mm)
{
    std::vector<double> own;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::abs(profile.radius_mm[profile.binOf(shape, points.turn[i], points.z_mm[i])] - level_mm) <
            points.onShape_mm())
            own.push_back(points.r_mm[i]);
    return own.empty() ? level_mm : upperMedianInPlace(own);
}

std::string moduleName(double pitch_mm, double depth_mm)
{
    for (const double module_mm : modules_mm) {
        const double in_modules = depth_mm / module_mm;
        if (std::abs(pitch_mm / std::numbers::pi - module_mm) < helixLimits.module_share * module_mm &&
            in_modules > helixLimits.least_worm_depth && in_modules < helixLimits.most_worm_depth)
            return fmt::format("m {:g}", module_mm);
    }
    return "";
}

}  // namespace

std::optional<FoundShape> helixOf(const StretchPoints& points, const Progress& progress)
{
    const auto [low, high] = std::minmax_element(points.z_mm.begin(), points.z_mm.end());
    const double length = *high - *low;
    if (!(length > helixLimits.shortest_pitch_mm)) return std::nullopt;
    FoundHelix helix = bestHelix(points, length, progress);
    const double pitch = 1 / std::abs(helix.shape.waves_per_mm);
    if (helix.explained < helixLimits.least_explained || length < helixLimits.least_pitches * pitch)
        return std::nullopt;
    const auto first = pitchProfile(points, helix.shape);
    if (!first) return std::nullopt;
    const ToothLevels levels = levelsOf(*first);
    if (levels.depth_mm() < helixLimits.least_depth_mm || !isOneTooth(*first, levels)) return std::nullopt;
    FoundShape found{helix.shape, {}};
    SectionShape& shape = found.shape;
    shape.phase_turn = toothMiddle(*first, levels) / static_cast<double>(shape.count);
    const auto profile = pitchProfile(points, shape);
    if (!profile) return std::nullopt;
    const auto [crest, crest_u] = crestOfHelix(points, levels.crest_mm);
    const double root = rootOfHelix(points, shape, *profile, levels.root_mm);
    shape.level_mm = crest;
    shape.pitch_mm = steadyRadii(*profile, points.sigma_mm);
    found.mark.kind = MarkKind::Thread;
    found.mark.pitch_mm = pitch;
    found.mark.starts = static_cast<double>(shape.count);
    found.mark.hand = shape.waves_per_mm > 0 ? 1 : -1;
    found.mark.major_mm = 2 * crest;
    found.mark.minor_mm = 2 * root;
    found.mark.uncertainty_mm = 4 * crest_u;  // k = 2, of a diameter
    found.mark.designation = moduleName(pitch, crest - root);
    return found;
}

}  // namespace lathelier::features
