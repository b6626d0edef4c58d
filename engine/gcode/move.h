// One canonical move of the tool, independent of the control, in millimetres and radii.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/core/units.h"

namespace lathelier::gcode {

enum class MoveKind : std::uint8_t { Rapid, Feed, Arc, Thread, Dwell };

/// "rapid", "feed", "arc", "thread", "dwell".
const char* key(MoveKind kind);

/// End of a move in program coordinates. Missing values are NaN: coordinates of a reference point, the centre of a
/// straight line, the feed of a rapid move.
struct Move {
    std::int64_t line = 0;                    ///< of the block that caused it, from 1
    MoveKind kind = MoveKind::Rapid;          ///< how the tool moves
    bool clockwise = false;                   ///< of an arc: G2, seen with Z to the right and X upward
    double x_mm = notANumber;                 ///< radius
    double z_mm = notANumber;                 ///< program coordinate
    double centre_x_mm = notANumber;          ///< of an arc, radius
    double centre_z_mm = notANumber;          ///< of an arc
    double feed_mm_rev = notANumber;          ///< feed or lead of a thread
    double feed_mm_min = notANumber;          ///< feed, where it is per minute
    double speed_rpm = notANumber;            ///< of the spindle (G97)
    double cutting_speed_m_min = notANumber;  ///< constant surface speed (G96)
    double speed_limit_rpm = notANumber;      ///< of G96: G50 S, LIMS=, D
    double dwell_s = notANumber;              ///< of a dwell
    int tool = 0;                             ///< number of the tool; 0: none yet
    bool passes_point = false;                ///< true: it leads to the intermediate point of G28
};

inline bool isKnown(double value)
{
    return !std::isnan(value);
}

/// A point of the plane of turning.
struct Point {
    double x_mm = notANumber;  ///< radius
    double z_mm = notANumber;  ///< along the axis
};

inline bool isKnown(const Point& point)
{
    return isKnown(point.x_mm) && isKnown(point.z_mm);
}

}  // namespace lathelier::gcode
