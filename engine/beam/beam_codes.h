// Error codes of beam models, with their English patterns. {name} is replaced by the named value; text() prefixes path,
// line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode shaftSegmentUnusable{
    "shaft_segment_unusable", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Segment {segment} of the shaft: {quantity} is {found_mm} mm; expected {expected}.")};

inline constexpr ErrorCode placeOutsideShaft{
    "place_outside_shaft", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "The place z = {z_mm} mm is not on the shaft; expected 0 to {length_mm} mm.")};

}  // namespace errors

}  // namespace lathelier
