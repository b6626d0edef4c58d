// Sharp drawn edges with a chamfer: the job's `edge_break_mm`.
#pragma once

#include <cstdint>

#include "engine/cam/job.h"
#include "engine/core/shaft.h"

namespace lathelier::cam {

/// A part whose edges are broken.
struct BrokenEdges {
    Shaft part;              ///< with a row more for each chamfer
    std::int64_t count = 0;  ///< edges that were broken
    std::int64_t left = 0;   ///< edges whose face or row is too short for it
};

/// Is the end toward the chuck finished in this clamping, so that its edge is broken? By the second clamping, or where
/// the part is cut off, before that.
bool breaksEnd(const Job& job, bool is_second);

/// Chamfers with legs of `leg_mm` along and across the axis where a straight row that leans no more than 30° meets a
/// face: at the free end and on both sides of shoulders, and at the other end where `breaks_end` says so: else it is
/// cut off or held. Rows keep their z, limits and threads; a row shorter than three legs, or a face lower than a leg,
/// keeps its edge. leg 0: as drawn.
BrokenEdges brokenEdges(const Shaft& part, double leg_mm, bool breaks_end = false);

}  // namespace lathelier::cam
