// Features that are not bodies of revolution: keyways, flats, free forms beside the walls; threads and knurls in rough
// zones.
//
// Regions of the map (z, θ) where more than half of the points lie off the model by more than 5 σ are marks
// (off_regions.h). A plane r·cos(θ - θ₀) = h through a region is a keyway's floor or a flat; the width and the ends of
// a keyway are those of its rim (slot.h). Threads and knurls are peaks of a spectrum (periodic_mark.h).
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Marks of the outside in order of z, in the frame of the fit (z not yet from the free end). `bore`: points nearer to
/// it are none; nullptr without one. `scanner`: whose rays made the points, where it is known.
std::vector<ShaftMark> findMarks(const MeridianCloud& cloud, const Outline& outline, const Outline* bore,
                                 const std::optional<registration::ScannerAxis>& scanner,
                                 const Progress& progress = {});

}  // namespace lathelier::features
