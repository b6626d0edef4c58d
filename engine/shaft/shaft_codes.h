// Errors and notes about a shaft's definition: codes with their English patterns. {name} is replaced by the named
// value.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode shaftEmpty{"shaft_empty", ErrorKind::InputRejected,
                                      LT_TEXT("Engine", "The shaft has no segment that is longer than 0.")};

inline constexpr ErrorCode shaftRowWrong{
    "shaft_row_wrong", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Row {row} of the {contour}: {quantity} is {found}; expected {expected}.")};

inline constexpr ErrorCode shaftCrosses{
    "shaft_crosses", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "Row {row} of the {contour} crosses row {other_row} of the {other_contour} at z {z_mm} mm, ⌀ {diameter_mm} "
            "mm; a contour must not cross itself or a bore.")};

inline constexpr ErrorCode shaftBoresMeet{
    "shaft_bores_meet", ErrorKind::InputRejected,
    LT_TEXT(
        "Engine",
        "The bores meet: they are {free_mm} mm and {chuck_mm} mm deep, the part {length_mm} mm long; a through bore "
        "is one bore as long as the part.")};

inline constexpr ErrorCode boresStatedTwice{
    "bores_stated_twice", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The shaft states bores in its segments and in a list of bores; one of the two is allowed.")};

inline constexpr ErrorCode shaftIncomplete{
    "shaft_incomplete", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The shaft is not complete: {reason}. No drawing or CAD file is made of it.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode shaftUnexplained{
    "shaft_unexplained", Severity::Warning,
    LT_TEXT("Engine",
            "From z {z_start_mm:1} to {z_end_mm:1} mm the scan shows structure that the rows of the shaft do not "
            "describe."),
    NoteRole::NotModelled};

inline constexpr NoteCode shaftRowShort{
    "shaft_row_short", Severity::Warning,
    LT_TEXT("Engine", "Row {row} of the {contour} is {length_mm} mm long, less than 0.05 mm.")};

inline constexpr NoteCode shaftRowsInLine{
    "shaft_rows_in_line", Severity::Warning,
    LT_TEXT("Engine", "Rows {row} and {other_row} of the {contour} are one line.")};

inline constexpr NoteCode shaftWallThin{
    "shaft_wall_thin", Severity::Warning,
    LT_TEXT("Engine", "The wall between outside and bore is {wall_mm} mm at z {z_mm} mm.")};

inline constexpr NoteCode markOutsideRow{
    "mark_outside_row", Severity::Warning,
    LT_TEXT("Engine", "The mark {kind} from z {z_start_mm} to {z_end_mm} mm lies on no single row of the shaft.")};

}  // namespace notes

}  // namespace lathelier
