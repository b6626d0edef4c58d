// A shaft of which a part of the length has been turned down.
#pragma once

#include "engine/shaft/shaft.h"

namespace lathelier::stability {

/// Between `from_z_mm` and `to_z_mm` the outer radius is reduced by `depth_mm`; the segments are split there. An arc
/// keeps its radius. Errors: placeOutsideShaft; shaftSegmentUnusable if no material, or none around the bore, would be
/// left.
Shaft cutShaft(const Shaft& stock, double from_z_mm, double to_z_mm, double depth_mm);

/// Outer diameter at z; at a shoulder that toward the free end.
double diameterAt_mm(const Shaft& shaft, double z_mm);

}  // namespace lathelier::stability
