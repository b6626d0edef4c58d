// What cuts, move by move: the nose of an insert as a disc on the path of its centre, a blade as a rounded box.
//
// With the imaginary tip at (z, x) the nose centre is (z ∓ r, x + r) of tools that feed toward (from) the chuck; a
// blade of width w whose corners have radius c is a box from z - w + c to z - c, from x + c upward, rounded by c. On a
// straight move the box covers the hull of its two placements; on an arc its two lower corners follow arcs. Every arc
// keeps its radius, only its centre is shifted.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/cam/job.h"
#include "engine/core/error.h"
#include "engine/gcode/move.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::cam {

using stock::ConvexPolygon;
using stock::Corner;

/// Everything nearer than `radius_mm` to a straight line, an arc or a convex polygon is cut.
struct CutterStroke {
    std::int64_t line = 0;                        ///< of the block
    int tool = 0;                                 ///< number
    double radius_mm = 0;                         ///< of nose or corner
    Corner from, to;                              ///< ends of the line or arc
    bool is_arc = false;                          ///< about `centre`
    Corner centre;                                ///< of an arc
    double begin = 0;                             ///< of an arc: angle of its start
    double sweep = 0;                             ///< of an arc: signed angle to its end
    double from_radius_mm = 0, to_radius_mm = 0;  ///< of an arc at both ends; evenly in between
    ConvexPolygon body;                           ///< of a blade; not empty: instead of line and arc

    /// Distance from the line, arc or polygon, less the radius; negative: the place is cut, so deep at most.
    double clearance_mm(const Corner& place) const;
};

/// How a program's coordinates become those of the drawing: z = z_zero - Z, from the other end z = length - (…).
struct PathPlace {
    double z_zero_mm = 0;      ///< z of the program's Z0
    bool is_mirrored = false;  ///< the work was turned round since
    double length_mm = 0;      ///< of the part, for a mirrored path
};

/// Of all feed moves, arcs and threads with a known start. Drills have none. Notes: toolNotInJob once for each number.
std::vector<CutterStroke> cutterPath(std::span<const gcode::Move> moves, const Job& job, const PathPlace& place,
                                     Notes& notes);

}  // namespace lathelier::cam
