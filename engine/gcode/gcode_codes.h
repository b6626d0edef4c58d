// Errors and notes of reading NC programs: codes with their English patterns. Those of a program itself are diagnostics
// (diagnostic.h): an ErrorCode is one of severity error, a NoteCode one of severity warning. {name} is replaced by the
// named value; text() puts path, line and column in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode ncDialectNotRead{
    "nc_dialect_not_read", ErrorKind::InputRejected,
    LT_TEXT("Engine", "This program is written for {found}, which is not read; expected {expected}.")};

inline constexpr ErrorCode dialectUnclear{
    "dialect_unclear", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The program may be for {first} or for {second}, which read its numbers differently; state the "
            "control: {choices}.")};

inline constexpr ErrorCode ncTooLong{
    "nc_program_too_long", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The program has {found_MiB} MiB; at most {most_MiB} are read.")};

inline constexpr ErrorCode subprogramsTooLarge{
    "subprograms_too_large", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The folder of subprograms holds {found} {unit}; at most {most} are looked at.")};

inline constexpr ErrorCode ncCharacter{"nc_character_unexpected", ErrorKind::InputRejected,
                                       LT_TEXT("Engine", "“{found}” begins no word of an NC program.")};

inline constexpr ErrorCode ncNumberMissing{"nc_number_missing", ErrorKind::InputRejected,
                                           LT_TEXT("Engine", "Expected a number behind “{found}”.")};

inline constexpr ErrorCode ncCommentOpen{"nc_comment_not_closed", ErrorKind::InputRejected,
                                         LT_TEXT("Engine", "The comment is not closed.")};

inline constexpr ErrorCode ncExpression{"nc_expression_malformed", ErrorKind::InputRejected,
                                        LT_TEXT("Engine", "“{found}” cannot be computed: {reason}.")};

inline constexpr ErrorCode ncFeedMissing{"nc_feed_missing", ErrorKind::InputRejected,
                                         LT_TEXT("Engine", "A feed move without a feed: no F is in force.")};

inline constexpr ErrorCode ncMotionMissing{
    "nc_motion_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "A position without a motion: none of G0, G1, G2, G3 is in force.")};

inline constexpr ErrorCode ncArcIncomplete{"nc_arc_incomplete", ErrorKind::InputRejected,
                                           LT_TEXT("Engine", "An arc needs its centre (I, K) or its radius.")};

inline constexpr ErrorCode ncArcRadius{
    "nc_arc_radius_too_small", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The radius {radius_mm:4} mm does not reach: half of the chord is {half_chord_mm:4} mm.")};

inline constexpr ErrorCode ncArcEnd{
    "nc_arc_end_off_circle", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The end of the arc lies {distance_mm:4} mm off the circle of radius {radius_mm:4} mm.")};

inline constexpr ErrorCode ncCorner{
    "nc_corner_impossible", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The chamfer or rounding of {size_mm:4} mm does not fit between the two moves.")};

inline constexpr ErrorCode ncCycle{"nc_cycle_incomplete", ErrorKind::InputRejected,
                                   LT_TEXT("Engine", "{cycle} cannot be run: {reason}.")};

inline constexpr ErrorCode ncSequence{"nc_sequence_missing", ErrorKind::InputRejected,
                                      LT_TEXT("Engine", "The block {found} is not in the program.")};

inline constexpr ErrorCode ncNesting{"nc_nesting_too_deep", ErrorKind::InputRejected,
                                     LT_TEXT("Engine", "Subprograms or loops are nested more than {most} deep.")};

inline constexpr ErrorCode ncLoops{
    "nc_loop_limit", ErrorKind::InputRejected,
    LT_TEXT("Engine", "More than {most} repetitions: the program does not seem to come to an end.")};

inline constexpr ErrorCode ncBlocksRun{
    "nc_block_limit", ErrorKind::InputRejected,
    LT_TEXT("Engine", "More than {most} blocks are run: the program does not seem to come to an end.")};

inline constexpr ErrorCode ncMoves{"nc_move_limit", ErrorKind::InputRejected,
                                   LT_TEXT("Engine", "The program makes more than {most} moves.")};

inline constexpr ErrorCode ncFlow{"nc_flow_unmatched", ErrorKind::InputRejected,
                                  LT_TEXT("Engine", "“{found}” has no counterpart.")};

inline constexpr ErrorCode ncNoseFit{
    "nose_does_not_fit", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The nose of radius {radius_mm:4} mm does not fit into this corner without a gouge.")};

inline constexpr ErrorCode ncAlarm{"nc_alarm", ErrorKind::InputRejected,
                                   LT_TEXT("Engine", "The program stops itself here: {found}.")};

inline constexpr ErrorCode ncSequenceTwice{
    "nc_sequence_twice", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The block {found} stands in lines {first} and {second}: which one the cycle means is not clear.")};

inline constexpr ErrorCode ncCoordinate{
    "nc_coordinate_too_large", ErrorKind::InputRejected,
    LT_TEXT("Engine", "“{found}” leads {distance_m:0} m away; at most {most_m:0} m are read.")};

inline constexpr ErrorCode ncPasses{"nc_pass_limit", ErrorKind::InputRejected,
                                    LT_TEXT("Engine", "The cycle makes {found} passes; at most {most} are read.")};

inline constexpr ErrorCode ncEmpty{"nc_program_empty", ErrorKind::InputRejected,
                                   LT_TEXT("Engine", "The file holds no block of a program.")};

inline constexpr ErrorCode ncVariableUnknown{
    "nc_variable_not_known", ErrorKind::InputRejected,
    LT_TEXT("Engine", "“{word}” needs {found}, to which the program gives no value.")};

inline constexpr ErrorCode ncGroups{"nc_words_conflict", ErrorKind::InputRejected,
                                    LT_TEXT("Engine", "“{found}” contradicts another word of the same block.")};

inline constexpr ErrorCode ncValue{"nc_value_unusable", ErrorKind::InputRejected,
                                   LT_TEXT("Engine", "“{found}”: expected {expected}.")};

inline constexpr ErrorCode toolTableMalformed{"tool_table_malformed", ErrorKind::InputRejected,
                                              LT_TEXT("Engine", "Found “{found}”, expected {expected}.")};

inline constexpr ErrorCode ncBlockNotRewritable{
    "block_not_rewritable", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The block “{block}” may not be changed: {word} {reason}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode ncWordUnknown{"nc_word_unknown", Severity::Warning,
                                        LT_TEXT("Engine", "The word “{found}” is not known; it is not modelled.")};

inline constexpr NoteCode ncWordNotModelled{"nc_word_not_modelled", Severity::Warning,
                                            LT_TEXT("Engine", "“{found}” is known, but what it does is not modelled.")};

inline constexpr NoteCode ncBlockNotModelled{
    "nc_block_not_modelled", Severity::Warning,
    LT_TEXT("Engine", "The block is not modelled because of “{found}”: its moves are missing.")};

inline constexpr NoteCode ncIntegerWord{
    "nc_integer_without_point", Severity::Warning,
    LT_TEXT("Engine", "“{found}” has no decimal point; read as {read_as_mm:4} mm.")};

inline constexpr NoteCode ncWordRepeated{"nc_word_repeated", Severity::Warning,
                                         LT_TEXT("Engine", "“{found}” replaces an earlier word of the same block.")};

inline constexpr NoteCode ncWordWithoutUse{"nc_word_without_use", Severity::Warning,
                                           LT_TEXT("Engine", "“{found}” has no use in this block.")};

inline constexpr NoteCode ncArcOffCircle{
    "nc_arc_end_near_circle", Severity::Warning,
    LT_TEXT("Engine", "The end of the arc lies {distance_mm:4} mm off the circle of radius {radius_mm:4} mm.")};

inline constexpr NoteCode ncFeedKept{
    "nc_feed_of_other_mode", Severity::Warning,
    LT_TEXT("Engine", "The feed {found} was given in the other mode (per revolution, per minute).")};

inline constexpr NoteCode ncAssumed{"nc_state_assumed", Severity::Warning,
                                    LT_TEXT("Engine", "The program does not state {what}; assumed: {assumed}.")};

inline constexpr NoteCode noseRadiusUnknown{
    "nose_radius_unknown", Severity::Warning,
    LT_TEXT("Engine",
            "Nose radius compensation without a known radius, up to line {last}: the programmed contour is shown.")};

inline constexpr NoteCode ncCycleStartsInside{
    "nc_cycle_starts_inside", Severity::Warning,
    LT_TEXT("Engine",
            "The cycle starts at a radius of {start_mm:4} mm, within its contour, which reaches {reach_mm:4} mm: its "
            "rapid moves lead through the work.")};

inline constexpr NoteCode ncPositionUnknown{"nc_position_unknown", Severity::Warning,
                                            LT_TEXT("Engine", "The move starts from a position that is not known.")};

inline constexpr NoteCode ncOffsetUnknown{
    "nc_offset_unknown", Severity::Warning,
    LT_TEXT("Engine", "“{found}” shifts the coordinates by an amount that the program does not state.")};

inline constexpr NoteCode ncSubprogramRead{
    "nc_subprogram_read", Severity::Info,
    LT_TEXT("Engine", "Lines {first_line} to {last_line} of this answer are lines 1 to {lines} of {path}.")};

inline constexpr NoteCode ncSubprogramMissing{
    "nc_subprogram_missing", Severity::Warning,
    LT_TEXT("Engine", "The subprogram {found} is not in this file; what it does is not known.")};

inline constexpr NoteCode ncMainRepeats{
    "nc_main_program_repeats", Severity::Warning,
    LT_TEXT("Engine", "M99 in the main program starts it again; it is followed once.")};

inline constexpr NoteCode ncMoreDiagnostics{"nc_more_diagnostics", Severity::Warning,
                                            LT_TEXT("Engine", "Further places with {found}, not listed: {count}.")};

inline constexpr NoteCode ncVariableUnset{"nc_variable_unset", Severity::Warning,
                                          LT_TEXT("Engine", "“{found}” has no value here; read as 0.")};

}  // namespace notes

}  // namespace lathelier
