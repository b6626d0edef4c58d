// Sees where the planes of an outline are, with the radii as its model has them.
#pragma once

#include <vector>

#include "engine/features/stretches.h"

namespace lathelier::features {

/// Shoulders by the rays of the scan or by their faces, steps by the points that change, ends by where hits stop. Sets
/// the planes and their uncertainties, the width of the spot, and what the ends are. `borders`: one for each plane.
void placePlanes(const OutlineInput& input, Outline& outline, const std::vector<Border>& borders,
                 const Progress& progress);

}  // namespace lathelier::features
