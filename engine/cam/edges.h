// Sharp drawn edges with a chamfer: the job's `edge_break_mm`.
#pragma once

#include <cstdint>

#include "engine/cam/job.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cam {

/// A part with chamfered edges.
struct BrokenEdges {
    Shaft part;              ///< with one additional row per chamfer
    std::int64_t count = 0;  ///< edges that were broken
    std::int64_t left = 0;   ///< edges whose face or row is too short for it
};

/// True if the end toward the chuck is finished in this clamping, so that its edge is broken: in the second clamping,
/// or before parting off.
bool breaksEnd(const Job& job, bool is_second);

/// Chamfers with legs of `leg_mm` along and across the axis where a straight row inclined by at most 30° adjoins a
/// face: at the free end and on both sides of shoulders, and at the other end if `breaks_end`; otherwise that end is
/// parted off or clamped. Rows keep their z, limits and threads; a row shorter than three legs, or a face lower than a
/// leg, keeps its edge. leg 0: as drawn.
BrokenEdges brokenEdges(const Shaft& part, double leg_mm, bool breaks_end = false);

}  // namespace lathelier::cam
