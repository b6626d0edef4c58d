// Error and note codes of readers of time records, with their English patterns. {name} is replaced by the named value;
// text() prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode timeUneven{
    "time_uneven", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The samples are not even in time: a step of {found_s} s among steps of {expected_s} s. Expected are steps "
            "that differ by at most 1 %.")};

inline constexpr ErrorCode timeRecordNone{
    "time_record_none", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The file holds no signals over time: found {found}, expected {expected}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode timeSetsSkipped{
    "time_sets_skipped", Severity::Info,
    LT_TEXT("Engine", "{path}: {count} functions are no signals over time, the first at line {line}.")};

}  // namespace notes

}  // namespace lathelier
