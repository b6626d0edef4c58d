// Errors and notes of the lines of a measured response, with their English patterns (core/error.h).
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode rangeWithoutLines{
    "range_without_lines", ErrorKind::NoAnswer,
    LT_TEXT(
        "Engine",
        "From {from_hz} to {to_hz} Hz the response has {found} lines; at least 4 are needed. It runs from {first_hz} "
        "to {last_hz} Hz.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode linesOfNoiseLeftOut{
    "lines_of_noise_left_out", Severity::Info,
    LT_TEXT("Engine",
            "{path}: {count} lines hold no more than the noise of the sensor and are left out; used is {from_hz} to "
            "{to_hz} Hz. --range-hz states another range.")};

inline constexpr NoteCode nothingAboveNoise{
    "nothing_above_noise", Severity::Warning,
    LT_TEXT("Engine", "{path}: nowhere does the response stand out of the noise of its lines."), NoteRole::NotModelled};

}  // namespace notes

}  // namespace lathelier
