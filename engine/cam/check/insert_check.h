// Check of the whole insert outline against the drawing: the edges may gouge where the nose does not.
//
// Each feed move sweeps the outline of the insert; a point of the drawing within it lies below the drawing's surface as
// seen from the tool. Its depth is the shortest distance to the boundary of the swept outline. Outlines stay within the
// true insert by 2 µm (stock/tool_outline.h), arcs are chords within 5 µm.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/cam/check/drawn_contour.h"
#include "engine/cam/job.h"
#include "engine/core/progress.h"
#include "engine/gcode/move.h"

namespace lathelier::cam {

inline constexpr double insertTouch_mm = 0.01;  ///< smaller penetration depths count as contact, not as a finding

/// A move whose insert penetrates the nominal contour, at the point of largest depth.
struct InsertBelow {
    std::int64_t line = 0;  ///< of the block
    Corner at;              ///< on the drawing
    double depth_mm = 0;    ///< distance to the boundary of the swept insert
};

/// Of all feed moves with tools of the job, in order. `z_zero_mm`: z of the program's Z0. Throws Cancelled.
std::vector<InsertBelow> insertsBelow(std::span<const gcode::Move> moves, const Job& job, const DrawnContour& drawing,
                                      double z_zero_mm, const Progress& progress = {});

}  // namespace lathelier::cam
