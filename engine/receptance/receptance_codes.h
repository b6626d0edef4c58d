// Error and note codes of the receptances of shafts on machines, with their English patterns. {name} is replaced by the
// named value; text() prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode frequencyOutsideSpindle{
    "frequency_outside_spindle", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The spindle is not known at {frequency_hz} Hz, only from {from_hz} to {to_hz} Hz.")};

inline constexpr ErrorCode tooFewMeasuredPoints{
    "too_few_measured_points", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "{points} points with {frfs} frequency responses are too few for the spindle; at least 2 points and 3 "
            "responses are needed.")};

inline constexpr ErrorCode measuredPointBeyondRod{
    "measured_point_beyond_rod", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "Rod {rod}, point {point}: {distance_mm} mm from the chuck; expected 0 to {length_mm} mm, the rod's "
            "length.")};

inline constexpr ErrorCode measuredPairUnknown{
    "measured_pair_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "A frequency response belongs to rod {rod}, points {first} and {second}, which are not stated.")};

inline constexpr ErrorCode measuredNodeMissing{
    "measured_node_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Rod {rod}: no frequency response with the node {node} is in the file.")};

inline constexpr ErrorCode frfLinesDiffer{
    "frf_lines_differ", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The frequency responses have different lines: {first}, {second}.")};

inline constexpr ErrorCode holdOutUnknown{"hold_out_unknown", ErrorKind::WrongUsage,
                                          LT_TEXT("Engine", "Rod {rod} cannot be held out; there are {rods} rods.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode materialAssumed{
    "material_assumed", Severity::Info,
    LT_TEXT("Engine",
            "No material is stated; steel is assumed (E {elastic_modulus_MPa} MPa, ρ {density_kg_m3} kg/m³)."),
    NoteRole::Assumed};

inline constexpr NoteCode materialOfLibrary{
    "material_of_library", Severity::Info,
    LT_TEXT("Engine", "Handbook values of {material} are assumed, not those of this bar (source: {source}).")};

inline constexpr NoteCode machineOfLibrary{
    "machine_of_library", Severity::Info,
    LT_TEXT("Engine", "The springs are taken from the library, not from this machine (source: {source}).")};

inline constexpr NoteCode spindleHasNoModes{
    "spindle_has_no_modes", Severity::Info,
    LT_TEXT("Engine", "The spindle is a table of receptances: natural frequencies do not follow from it.")};

inline constexpr NoteCode spindleIllConditioned{
    "spindle_ill_conditioned", Severity::Warning,
    LT_TEXT(
        "Engine",
        "At {lines} of {all} frequencies the measurements hardly tell the three receptances apart (condition number "
        "above {limit}).")};

inline constexpr NoteCode spindleNotConverged{
    "spindle_not_converged", Severity::Warning,
    LT_TEXT("Engine", "At {lines} of {all} frequencies the fit of the spindle did not converge.")};

inline constexpr NoteCode spindleNotPassive{
    "spindle_not_passive", Severity::Warning,
    LT_TEXT("Engine",
            "At {lines} of {all} frequencies the spindle found would give power away, by more than its uncertainty.")};

inline constexpr NoteCode spindleTableNotPassive{
    "spindle_table_not_passive", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: at {lines} of {all} frequencies, the first {frequency_hz} Hz, the receptance H of the spindle has "
            "a positive imaginary part: it would give power away.")};

inline constexpr NoteCode spindleNotExplained{
    "spindle_not_explained", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The spindle found leaves {percent:1} % of the responses unexplained, more than {limit} % and more than their "
        "noise ({expected:1} %)."),
    NoteRole::NotModelled};

inline constexpr NoteCode spindleSignTurned{
    "spindle_sign_turned", Severity::Warning,
    LT_TEXT("Engine",
            "Rod {rod}: the response {respond}/{excite} fits with its sign turned: residual {before_percent:1} → "
            "{after_percent:1} %. It is used as measured.")};

inline constexpr NoteCode spindlePointsSwapped{
    "spindle_points_swapped", Severity::Warning,
    LT_TEXT("Engine",
            "Rod {rod}: the responses fit with the points {first} and {second} swapped: residual {before_percent:1} → "
            "{after_percent:1} %. They are used as stated.")};

inline constexpr NoteCode spindlePointMisplaced{
    "spindle_point_misplaced", Severity::Warning,
    LT_TEXT("Engine",
            "Rod {rod}: the responses fit with the point {node} at {fitted_mm:1} mm from the chuck in place of "
            "{stated_mm:1} mm: residual {before_percent:1} → {after_percent:1} %. It is used as stated.")};

inline constexpr NoteCode spindleRodLength{
    "spindle_rod_length", Severity::Warning,
    LT_TEXT("Engine",
            "Rod {rod}: the responses fit with {fitted_mm:1} mm of it outside the chuck in place of {stated_mm:1} mm: "
            "residual {before_percent:1} → {after_percent:1} %. It is used as stated.")};

inline constexpr NoteCode spindleResponseStandsOut{
    "spindle_response_stands_out", Severity::Warning,
    LT_TEXT("Engine",
            "Rod {rod}: the response {respond}/{excite} contradicts the others: residual {before_percent:1} → "
            "{after_percent:1} % without it. It is used as measured.")};

inline constexpr NoteCode frfSlopeContradictsLabel{
    "frf_slope_contradicts_label", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: stated is {stated}, but up to {to_hz} Hz the magnitude goes with the power {slope} of the "
            "frequency, as that of {found} does. State the unit as it is, or convert the file.")};

inline constexpr NoteCode frfPowerGivenAway{
    "frf_power_given_away", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: in {percent} % of its lines the receptance has a positive imaginary part. If force and motion are "
            "at one place, a direction, a unit or the sign of time is stated wrongly.")};

}  // namespace notes

}  // namespace lathelier
