// Is a wall inside the part a bore, or the lower part of an outside that is not round?
//
// Rays reach a bore through its mouth: the outside is seen at the same places about the axis. The roots of a spline,
// the floor of a slot are seen where the outside is not. And a bore goes around; stray points do not.
#pragma once

#include "engine/core/progress.h"
#include "engine/features/structure/residual_map.h"
#include "engine/features/walls/walls.h"

namespace lathelier::features {

/// Thresholds of the proof.
struct BoreThresholds {
    double cell_mm = 1;         ///< along z
    int sectors = 720;          ///< around the axis: finer than the rays of a rotary scanner, coarser than its noise
    double least_shared = 0.5;  ///< of the places that walls seen independently share; interleaved ones share none
    double least_around = 0.5;  ///< of the circle that the outside is seen from
    int around_sectors = 72;    ///< sectors of that circle, 5°
    double near_sigmas = 4;     ///< points this near a wall belong to it
};
inline constexpr BoreThresholds boreThresholds{};

/// Removes the chains of bores that are none from both sets of walls. Throws Cancelled.
void keepProvenBores(const MeridianCloud& cloud, const SurfaceTable& outside, double sigma_mm, Walls& coarse,
                     Walls& fine, const Progress& progress = {});

}  // namespace lathelier::features
