// A shaft as a closed triangle mesh: its closed contour revolved about the axis, the reference that a scan is compared
// with.
//
// Every circle becomes a polygon of the same number of sides and the same area: its corners lie two thirds of the
// chord's sagitta outside the circle, the middles of its sides one third inside. Cross sections are exact so, and what
// lies between straight lines of the meridian has its exact volume. Arcs of the meridian become chords that enclose the
// same area with the arc's ends: the volume is off by less than the first order of the sagitta (its power 3/2).
#pragma once

#include <cstddef>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/features/comparison/comparison_limits.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

struct ShaftMesh {
    Scan scan;              ///< closed, its vertices shared; z along the axis from the free end; no normals
    double sagitta_mm = 0;  ///< chords of circles and of arcs stay below; more than requested where the number of
                            ///< triangles limits the mesh
};

/// Marks are left out. Preconditions: the shaft passes checkShaft(), sagitta_mm > 0. Throws Cancelled.
ShaftMesh shaftMesh(const Shaft& shaft, double sagitta_mm = meshingLimits.finest_sagitta_mm,
                    const Progress& progress = {});

}  // namespace lathelier::features
