// Errors and notes of a series: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode seriesEmpty{
    "series_empty", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The archive has no value of {characteristic} that satisfies what was asked for.")};

inline constexpr ErrorCode archiveEmpty{"archive_empty", ErrorKind::NoAnswer,
                                        LT_TEXT("Engine", "The archive has no evaluations with numbers yet.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode limitsDiffer{
    "series_limits_differ", Severity::Warning,
    LT_TEXT("Engine", "The limits of the characteristic differ within the series: no capability is stated.")};

inline constexpr NoteCode capabilityFewValues{
    "capability_few_values", Severity::Info,
    LT_TEXT("Engine", "{count} values are few for a capability; at least {least} are usual.")};

inline constexpr NoteCode capabilityOutOfControl{
    "capability_out_of_control", Severity::Warning,
    LT_TEXT("Engine",
            "The series is not in statistical control: what its capability says of later parts is uncertain.")};

inline constexpr NoteCode seriesShortened{
    "series_shortened", Severity::Info,
    LT_TEXT("Engine", "The latest {count} values are taken; there may be earlier ones.")};

}  // namespace notes

}  // namespace lathelier
