// Errors and notes of the stock simulation: codes with their English patterns. {name} is replaced by the named value;
// text() puts path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode stockWithoutLength{"stock_without_length", ErrorKind::InputRejected,
                                              LT_TEXT("Engine", "The stock has no length.")};

inline constexpr ErrorCode stockSegmentImpossible{
    "stock_segment_impossible", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "Segment {segment} of the stock cannot be: a negative or missing number, or an arc smaller than half its "
            "chord.")};

inline constexpr ErrorCode toolImpossible{
    "tool_impossible", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "Tool {tool} cannot be: entering angle {entering_angle_deg}°, tip angle {tip_angle_deg}°, corner radius "
            "{corner_radius_mm} mm. Both angles together must stay below 180°, and the corner must fit between the "
            "edges.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode aboveStockFeed{
    "above_stock_feed", Severity::Info,
    LT_TEXT("Engine", "Line {line}, z = {z_mm} mm: a feed move above the stock cuts air over {length_mm} mm.")};

inline constexpr NoteCode smallClearance{
    "clearance_below_0.1", Severity::Info,
    LT_TEXT("Engine", "Line {line}, z = {z_mm} mm: a rapid move passes the stock within 0.1 mm.")};

inline constexpr NoteCode morePlaces{"stock_more_places", Severity::Info,
                                     LT_TEXT("Engine", "Further places with {what}, not listed: {count}.")};

inline constexpr NoteCode startUnknown{
    "start_unknown", Severity::Info,
    LT_TEXT("Engine",
            "Line {line}: the move comes from a reference point whose place is not known; only its end is checked. "
            "Such moves: {count}.")};

inline constexpr NoteCode toolAssumed{
    "tool_shape_assumed", Severity::Warning,
    LT_TEXT("Engine",
            "The shape of tool {tool} is not fully stated; assumed are corner radius {corner_radius_mm} mm, entering "
            "angle {entering_angle_deg}°, tip angle {tip_angle_deg}°, reach {reach_mm} mm where they are missing."),
    NoteRole::Assumed};

inline constexpr NoteCode toolWithoutHolder{
    "tool_without_holder", Severity::Info,
    LT_TEXT("Engine", "Tool {tool} has no stated holder: its insert alone is checked.")};

inline constexpr NoteCode stockStepWidened{
    "stock_step_widened", Severity::Info,
    LT_TEXT("Engine",
            "Length of the stock and number of moves widen the columns of the stock to {step_mm} mm (asked: {asked_mm} "
            "mm) and the steps of a feed move to {feed_step_mm} mm.")};

inline constexpr NoteCode threadAsRoot{
    "thread_taken_as_root", Severity::Info,
    LT_TEXT("Engine", "Line {line}: a thread is taken off down to its root, as if it had no flanks.")};

inline constexpr NoteCode drillingNotModelled{
    "drilling_not_modelled", Severity::Warning,
    LT_TEXT("Engine",
            "Line {line}: tool {tool} feeds along the axis. It is not stated to be a drill; moves on the axis change "
            "no stock and are not checked against it.")};

inline constexpr NoteCode programTimeIncomplete{
    "program_time_incomplete", Severity::Warning,
    LT_TEXT("Engine", "Feed moves that state no feed or no speed are not in the time: {count}.")};

inline constexpr NoteCode outlinesThinned{
    "stock_outlines_thinned", Severity::Info,
    LT_TEXT("Engine", "The stock is kept after every {every}th pass only; there are {passes}.")};

}  // namespace notes

}  // namespace lathelier
