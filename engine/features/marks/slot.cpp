#include "engine/features/marks/slot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/features/marks/off_regions.h"
#include "engine/features/nominal/standards.h"

namespace lathelier::features {
namespace {

/// Limits of the rim of a slot; chosen on scans with known truth.
struct SlotLimits {
    double far_before_mm = 15,
           seen_mm = 0.3;                 ///< of a longer window, where the rim comes so near to the end of the first
    double beside_mm = 2, before_mm = 4;  ///< of the slot across and along it: the window
    double least_half_rad = 0.1, most_half_rad = 1.3;  ///< of a window about the axis
    double form_mm = 0.09;        ///< standard uncertainty of the width beside that of the rays: each edge is broken or
                                  ///< burred by up to 0.1 mm
    double end_gain = 8;          ///< log-likelihood by which a straight end must exceed a round one
    double most_change_mm = 2.5;  ///< of the width against the one that the floor gives
    double least_length = 1.25;   ///< times the width: shorter ones are no slots
    double shaft_mm = 0.1;        ///< by which a worn or measured shaft may exceed the range of a key
    double length_tolerance_mm = 0.3;  ///< of a slot for a key, DIN 6885-1: +0.3 over 28 mm
};
constexpr SlotLimits slotLimits{};

/// The most likely rim with round or straight ends.
RimShape bestEnds(const RimView& view, const RimShape& first, const Progress& progress)
{
    RimShape best = bestRim(view, first, progress);
    for (bool RimShape::*end : {&RimShape::round_start, &RimShape::round_end}) {
        RimShape straight = best;
        straight.*end = false;
        straight = bestRim(view, straight, progress);
        const double gain = logLikelihood(view, first, straight) - logLikelihood(view, first, best);
        if (gain > slotLimits.end_gain) best = straight;
    }
    return best;
}

/// The rim of a slot of about the half width.
RimFit fitSlot(const RimView& view, const ShaftMark& mark, double half_mm, const Progress& progress)
{
    RimShape first;
    first.kind = RimKind::Slot;
    first.low_mm = -half_mm;
    first.high_mm = half_mm;
    first.start_mm = *mark.z_start_mm;
    first.end_mm = std::max(*mark.z_end_mm, *mark.z_start_mm + 2 * half_mm);
    return fitRim(view, bestEnds(view, first, progress), progress);
}

}  // namespace

bool measureSlot(const WallScan& scan, ShaftMark& mark, const Progress& progress)
{
    const Run* const run = smoothRunAt(scan.model, (*mark.z_start_mm + *mark.z_end_mm) / 2);
    if (!run) return false;
    const double radius = radiusAt_mm(*run, (*mark.z_start_mm + *mark.z_end_mm) / 2), floor = *mark.floor_mm;
    const double half_rad = scan.surface_scan ? std::asin(std::min(0.95, *mark.width_mm / (2 * radius)))
                                              : std::atan(*mark.width_mm / (2 * floor));
    const double half = radius * std::sin(half_rad);
    WallWindow window{0, 0, *mark.angle_deg / deg_per_rad, 0};
    window.half_rad =
        std::clamp(half_rad + slotLimits.beside_mm / radius, slotLimits.least_half_rad, slotLimits.most_half_rad);
    RimFit fit;
    for (const double before_mm : {slotLimits.before_mm, slotLimits.far_before_mm}) {
        window.from_mm = *mark.z_start_mm - before_mm;
        window.to_mm = *mark.z_end_mm + before_mm;
        window = withinRun(*run, window);
        fit = fitSlot(raysAt(scan, *run, window, progress), mark, half, progress);
        const bool is_cut = fit.rim.start_mm < window.from_mm + slotLimits.seen_mm ||
                            fit.rim.end_mm > window.to_mm - slotLimits.seen_mm;
        if (!is_cut) break;
    }
    const double width = fit.rim.width_mm(), length = fit.rim.end_mm - fit.rim.start_mm;
    if (!(std::abs(width - 2 * half) < slotLimits.most_change_mm) || length < slotLimits.least_length * width)
        return false;
    mark.width_mm = width;
    mark.uncertainty_mm = 2 * std::hypot(fit.width_sigma_mm, slotLimits.form_mm);
    // An end that lies where the wall is not judged is that of the floor.
    if (fit.rim.start_mm > window.from_mm) mark.z_start_mm = fit.rim.start_mm;
    if (fit.rim.end_mm < window.to_mm) mark.z_end_mm = fit.rim.end_mm;
    mark.place_uncertainty_mm =
        2 * std::hypot(std::max(fit.start_sigma_mm, fit.end_sigma_mm), slotLimits.form_mm / std::numbers::sqrt2);
    mark.depth_mm = radius - floor;
    mark.designation = keyOf(mark, 2 * radius, fit.rim.round_start && fit.rim.round_end);
    return true;
}

std::string keyOf(const ShaftMark& slot, double shaft_mm, bool round_ends)
{
    if (!round_ends || !slot.width_mm || !slot.uncertainty_mm) return {};
    const double length = *slot.z_end_mm - *slot.z_start_mm;
    for (const ParallelKey& key : parallelKeys()) {
        if (shaft_mm < key.over_mm || shaft_mm > key.to_mm + slotLimits.shaft_mm) continue;
        if (std::abs(*slot.width_mm - key.width_mm) > *slot.uncertainty_mm) continue;
        std::string name = fmt::format("DIN 6885 - A {:g}×{:g}", key.width_mm, key.height_mm);
        for (const double standard_mm : keyLengths_mm())
            if (length > standard_mm - *slot.uncertainty_mm &&
                length < standard_mm + slotLimits.length_tolerance_mm + *slot.uncertainty_mm)
                return name + fmt::format("×{:g}", standard_mm);
        return name;
    }
    return {};
}

}  // namespace lathelier::features
