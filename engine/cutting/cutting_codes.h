// Errors of cutting forces: codes with their English patterns. {name} is replaced by the named value; text() puts path,
// line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode feedBeyondCorner{
    "feed_beyond_corner", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "A feed of {feed_mm_rev} mm per revolution leaves uncut rings: it has to be below twice the corner radius "
            "of {corner_radius_mm} mm.")};

inline constexpr ErrorCode feedMissing{
    "feed_missing", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "A cut has no feed per revolution; found {feed_mm_rev} mm per revolution.")};

inline constexpr ErrorCode edgeCannotEnter{
    "edge_cannot_enter", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "The cutting edge stands at {entering_angle_deg}° to the direction of the feed; expected from "
            "{minimum_deg}° to {maximum_deg}°.")};

}  // namespace errors

}  // namespace lathelier
