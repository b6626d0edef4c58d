// Errors and notes of turning programs: codes with their English patterns. {name} is replaced by the named value;
// text() puts path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

// The job.

inline constexpr ErrorCode jobWithoutShaft{
    "job_without_shaft", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The part is not stated: neither a shaft was given nor does the job hold one.")};

inline constexpr ErrorCode stockSmallerThanPart{
    "stock_smaller_than_part", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The part does not fit into the stock at z = {z_mm} mm: {missing_mm} mm of {quantity} are missing.")};

inline constexpr ErrorCode segmentImpossible{
    "segment_impossible", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Segment {segment} of the part cannot be turned: {quantity} is {found}; expected {expected}.")};

// Tools.

inline constexpr ErrorCode toolNumberTwice{"tool_number_twice", ErrorKind::InputRejected,
                                           LT_TEXT("Engine", "The number {tool} is that of two tools.")};

inline constexpr ErrorCode toolIncomplete{"tool_incomplete", ErrorKind::InputRejected,
                                          LT_TEXT("Engine", "Tool {tool} ({use}) does not state its {quantity}.")};

inline constexpr ErrorCode toolMissing{"tool_missing", ErrorKind::InputRejected,
                                       LT_TEXT("Engine", "The job has no tool for {use}.")};

inline constexpr ErrorCode toolNotInLibrary{
    "tool_not_in_library", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Tool {tool}: “{found}” is not in the library; expected one of: {expected}.")};

inline constexpr ErrorCode toolTooShort{
    "tool_too_short", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Blade {tool} reaches {reach_mm} mm; parting off needs {needed_mm} mm.")};

}  // namespace errors

namespace notes {

// The job.

inline constexpr NoteCode speedNotLimited{"speed_not_limited", Severity::Info,
                                          LT_TEXT("Engine", "The job states no highest speed of the spindle.")};

inline constexpr NoteCode jobChanged{
    "job_changed", Severity::Info,
    LT_TEXT("Engine", "The job is that of the form, which was changed since {source} was opened.")};

// The check of a program.

inline constexpr NoteCode toolNotInJob{
    "tool_not_in_job", Severity::Warning,
    LT_TEXT("Engine",
            "Line {line}: tool {tool} is not in the job. What it leaves is not measured, and its shape is assumed.")};

inline constexpr NoteCode drawnNotChecked{
    "drawn_not_checked", Severity::Warning,
    LT_TEXT("Engine",
            "The drawing has a feature that the check does not look at: {feature} {designation} at z = {z_start_mm} … "
            "{z_end_mm} mm.")};

inline constexpr NoteCode toolChangeNearWork{
    "tool_change_near_work", Severity::Warning,
    LT_TEXT(
        "Engine",
        "Before line {line}: tool {tool} is called {distance_mm:1} mm from the work or what holds it; the turret is "
        "not modelled.")};

inline constexpr NoteCode workCutOff{
    "work_cut_off", Severity::Info,
    LT_TEXT("Engine",
            "The program stops for the work to be cut off to {length_mm:2} mm; it is checked with that length.")};

inline constexpr NoteCode cutOffAssumed{
    "cut_off_assumed", Severity::Warning,
    LT_TEXT("Engine",
            "Assumed: the work of the second clamping is cut off to {length_mm:2} mm. Neither the job nor the program "
            "says so.")};

inline constexpr NoteCode secondChuckUnknown{
    "second_chuck_unknown", Severity::Info,
    LT_TEXT("Engine", "Where the chuck stands in the second clamping is not stated; it is not looked at.")};

}  // namespace notes

}  // namespace lathelier
