#include "engine/form/roundness/roundness_hints.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::form {
namespace {

constexpr double leastShare_percent = 10;
constexpr std::size_t mostHints = 4;

}  // namespace

Text usualCause(int upr)
{
    switch (upr) {
        case 1: return LT_TEXT("Engine", "eccentricity: how the part sat on the measuring axis; no form");
        case 2: return LT_TEXT("Engine", "oval: clamping between two jaws, an oval spindle bearing, or an oval blank");
        case 3: return LT_TEXT("Engine", "three lobes: the clamping force of a three-jaw chuck");
        case 4: return LT_TEXT("Engine", "four lobes: the clamping force of a four-jaw chuck");
        case 5: return LT_TEXT("Engine", "five lobes: centreless ground bar stock, or a five-pad clamping");
        case 6: return LT_TEXT("Engine", "six lobes: a six-jaw chuck, or three jaws that press on pairs of spots");
        default: break;
    }
    if (upr <= 14) return LT_TEXT("Engine", "several lobes: spindle bearing, its balls or rollers, or the drive");
    if (upr <= 50) return LT_TEXT("Engine", "waves: vibration of workpiece or tool at a multiple of the spindle speed");
    return LT_TEXT("Engine", "short waves: chatter, or the trace of the tool's feed");
}

Text shortCause(int upr)
{
    switch (upr) {
        case 2: return LT_TEXT("Engine", "oval");
        case 3: return LT_TEXT("Engine", "three-jaw chuck?");
        case 4: return LT_TEXT("Engine", "four-jaw chuck?");
        case 5: return LT_TEXT("Engine", "five lobes");
        case 6: return LT_TEXT("Engine", "six lobes");
        default: break;
    }
    if (upr <= 14) return LT_TEXT("Engine", "bearing or drive?");
    if (upr <= 50) return LT_TEXT("Engine", "vibration?");
    return LT_TEXT("Engine", "chatter or feed?");
}

std::vector<RoundnessHint> roundnessHints(const RoundnessResult& result)
{
    double variance = 0;
    for (const signal::Harmonic& h : result.harmonics)
        if (h.upr >= 2) variance += h.amplitude * h.amplitude / 2;
    std::vector<RoundnessHint> hints;
    for (std::size_t k = 0; k < result.harmonics.size(); ++k) {
        const signal::Harmonic& h = result.harmonics[k];
        const double share = variance > 0 ? 100 * h.amplitude * h.amplitude / 2 / variance : 0;
        if (h.upr >= 2 && share >= leastShare_percent && h.amplitude > result.harmonic_floor_um[k])
            hints.push_back({h.upr, h.amplitude, share, usualCause(h.upr)});
    }
    std::stable_sort(hints.begin(), hints.end(),
                     [](const RoundnessHint& a, const RoundnessHint& b) { return a.amplitude_um > b.amplitude_um; });
    hints.resize(std::min(hints.size(), mostHints));
    const FittedCircle& circle = result.circles.LSCI;
    const double eccentricity_um = 1000 * circle.centre_mm.norm();
    if (eccentricity_um > circle.RONt_um && circle.centre_mm.norm() < circle.radius_mm)
        hints.push_back({1, eccentricity_um, notANumber, usualCause(1)});
    return hints;
}

}  // namespace lathelier::form
