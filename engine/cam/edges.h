// Sharp drawn edges with a chamfer: the job's `edge_break_mm`.
#pragma once

#include <cstdint>

#include "engine/core/shaft.h"

namespace lathelier::cam {

/// A part whose edges are broken.
struct BrokenEdges {
    Shaft part;              ///< with a row more for each chamfer
    std::int64_t count = 0;  ///< edges that were broken
    std::int64_t left = 0;   ///< edges whose face or row is too short for it
};

/// Chamfers with legs of `leg_mm` along and across the axis where a straight row that leans no more than 30° meets a
/// face: at the free end and on both sides of shoulders. The other end stays: it is cut off or held. Rows keep their z,
/// limits and threads; a row shorter than three legs, or a face lower than a leg, keeps its edge. leg 0: as drawn.
BrokenEdges brokenEdges(const Shaft& part, double leg_mm);

}  // namespace lathelier::cam
