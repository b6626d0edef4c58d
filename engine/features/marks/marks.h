// Features that are not bodies of revolution: keyways, flats, free forms beside the walls; threads and knurls in rough
// zones.
//
// Regions of the map (z, θ) where more than half of the points lie off the model by more than 5 σ are marks. A plane
// r·cos(θ - θ₀) = h through a region is a keyway's floor or a flat. Threads and knurls are peaks of the spectrum
// Σ r·e^{-i(2πfz + mθ)}: |m| ≤ 8 a thread with m starts and the lead 1/f, more a knurl with m teeth.
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Marks of the outside in order of z, in the frame of the fit (z not yet from the free end). `bore`: points nearer to
/// it are none; nullptr without one.
std::vector<ShaftMark> findMarks(const MeridianCloud& cloud, const Outline& outline, const Outline* bore,
                                 const Progress& progress = {});

/// The thread or knurl of one rough zone; kind empty where the spectrum has no peak.
ShaftMark periodicMark(const MeridianCloud& cloud, double from_mm, double to_mm, double about_mm, double sigma_mm,
                       const Progress& progress = {});

}  // namespace lathelier::features
