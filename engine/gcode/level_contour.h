// A contour as cycles with paraxial passes see it: along a depth axis p, which falls with the depth, and a feed axis q,
// which falls along the cut. Internal to the room.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/gcode/cycles.h"

namespace lathelier::gcode {

/// Levels and places closer than this are the same.
inline constexpr double sameLevel_mm = 1e-7;

/// A point by depth axis and feed axis.
struct Place {
    double p = 0;
    double q = 0;
};

/// The two axes: longitudinal passes (depth along X), or of a face (`is_face`: depth along Z).
struct LevelAxes {
    bool is_face = false;
    double sign_p = 1;
    double sign_q = 1;

    double depthAxis(const Point& point) const { return is_face ? point.z_mm : point.x_mm; }
    double feedAxis(const Point& point) const { return is_face ? point.x_mm : point.z_mm; }
    Place place(const Point& point) const { return {sign_p * depthAxis(point), sign_q * feedAxis(point)}; }
    Point point(const Place& at) const
    {
        return is_face ? Point{sign_q * at.q, sign_p * at.p} : Point{sign_p * at.p, sign_q * at.q};
    }
    /// In (q, p) the sense of rotation changes with each mirrored or exchanged axis.
    bool isMirrored() const { return (sign_p * sign_q < 0) != is_face; }
};

/// A part of the contour along which p is monotonic.
struct Stretch {
    Place from;
    Place to;
    Place centre;            ///< of an arc
    double radius = 0;       ///< of an arc; 0: straight
    bool is_upper = false;   ///< of an arc: q = centre + root, else centre - root
    bool clockwise = false;  ///< of an arc, as Piece counts it
    std::int64_t line = 0;
};

/// The pieces of the contour behind its first one, which leads to its start; arcs are split where p is largest or
/// smallest. All of it is moved by `shift`.
std::vector<Stretch> stretchesOf(const std::vector<ContourPiece>& contour, const LevelAxes& axes,
                                 const Point& shift = {0, 0});

/// q where the stretch has this p; the end of a stretch of constant p.
double crossing(const Stretch& part, double level);

}  // namespace lathelier::gcode
