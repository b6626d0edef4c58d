// What a change of recognised rows is refused for: codes with their English patterns. {name} is replaced by the named
// value.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode rowNotThere{
    "row_not_there", ErrorKind::InputRejected,
    LT_TEXT("Engine", "There is no row {row} to be changed: {rows} rows were recognised.")};

inline constexpr ErrorCode rowNotChangeable{"row_not_changeable", ErrorKind::InputRejected,
                                            LT_TEXT("Engine", "Row {row} cannot be changed like that: {reason}.")};

inline constexpr ErrorCode rowsDoNotMeet{
    "rows_do_not_meet", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "With these changes no contour fits the data: at z {z_mm} mm two rows do not meet.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode rowsChangedByHand{
    "rows_changed_by_hand", Severity::Info,
    LT_TEXT("Engine", "The rows were changed by hand ({count} times) and fitted again.")};

}  // namespace notes

}  // namespace lathelier
