// A round hole in a wall or face, proven by its rim.
#pragma once

#include <optional>

#include "engine/features/marks/rim_fit.h"

namespace lathelier::features {

/// A hole in the coordinates of its view.
struct RoundHole {
    double z_mm = 0, across_mm = 0, diameter_mm = 0;
    double diameter_sigma_mm = 0, place_sigma_mm = 0;  ///< standard uncertainties
};

/// The hole near the circle `first`: where the rim is a circle, the wall is missing inside and seen all around. None
/// where one of these is not so. Throws Cancelled.
std::optional<RoundHole> roundHole(const RimView& view, const RimShape& first, const Progress& progress = {});

}  // namespace lathelier::features
