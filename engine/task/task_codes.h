// Errors and notes of tasks: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode oneNeeded{"one_needed", ErrorKind::WrongUsage, LT_TEXT("Engine", "Still needed: {names}.")};

inline constexpr ErrorCode oneOnly{"one_only", ErrorKind::WrongUsage,
                                   LT_TEXT("Engine", "Only one of these can be given: {names}.")};

inline constexpr ErrorCode onlyWith{"only_with", ErrorKind::WrongUsage,
                                    LT_TEXT("Engine", "{name} says nothing here: it belongs to {names}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode shaftChanged{
    "shaft_changed", Severity::Info,
    LT_TEXT("Engine", "The shaft is that of the table, which was changed since {source} was opened.")};

}  // namespace notes

}  // namespace lathelier
