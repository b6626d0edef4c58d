// The volume cut by each move: the nose of an insert as a disc on the path of its centre, a blade as a rounded box.
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

/// The region cut by one move: all points nearer than `radius_mm` to a straight line, an arc or a convex polygon.
struct CutterStroke {
    std::int64_t line = 0;  ///< of the block
    int tool = 0;
    double radius_mm = 0;                         ///< nose radius of an insert, corner radius of a blade
    Corner from, to;                              ///< ends of the line or arc
    bool is_arc = false;                          ///< about `centre`
    Corner centre;                                ///< of an arc
    double begin = 0;                             ///< of an arc: angle of its start
    double sweep = 0;                             ///< of an arc: signed angle to its end
    double from_radius_mm = 0, to_radius_mm = 0;  ///< of an arc at its start and end; linear in between
    ConvexPolygon body;                           ///< swept polygon of a blade; if not empty, it replaces line and arc

    /// Distance from line, arc or polygon minus the radius. Negative: the point is cut; its magnitude bounds the depth.
    double clearance_mm(const Corner& place) const;
};

/// Transform from program to drawing coordinates: z = z_zero - Z; for a mirrored path z = length - (z_zero - Z).
struct PathPlace {
    double z_zero_mm = 0;      ///< z of the program's Z0
    bool is_mirrored = false;  ///< the path belongs to the other clamping
    double length_mm = 0;      ///< length of the part; used if mirrored
};

/// Of all feed moves, arcs and threads with a known start. Drills yield no strokes. Notes: toolNotInJob, once per tool
/// number.
std::vector<CutterStroke> cutterPath(std::span<const gcode::Move> moves, const Job& job, const PathPlace& place,
                                     Notes& notes);

}  // namespace lathelier::cam
