// Locates the planes of an outline, given the radii of its model.
#pragma once

#include <vector>

#include "engine/features/outline/stretches.h"

namespace lathelier::features {

/// Shoulders from the rays of the scan or from their faces, steps as change points of the radii, ends from the last
/// hits. Sets the planes and their uncertainties, the width of the spot, and the state of the ends. `borders`: one for
/// each plane.
void placePlanes(const OutlineInput& input, Outline& outline, const std::vector<Border>& borders,
                 const Progress& progress);

}  // namespace lathelier::features
