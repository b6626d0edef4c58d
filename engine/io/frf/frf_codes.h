// Error and note codes of readers of frequency responses, with their English patterns. {name} is replaced by the named
// value; text() prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode uffPointsMissing{
    "uff_points_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "A data set declares {expected} points (line {declared_line}) and holds {found}.")};

inline constexpr ErrorCode frfUnitMissing{
    "frf_unit_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "No unit of the frequency response is stated: found “{found}”, expected {expected}. State it.")};

inline constexpr ErrorCode frfNone{"frf_none", ErrorKind::InputRejected,
                                   LT_TEXT("Engine", "The file holds no frequency response: found {found}.")};

inline constexpr ErrorCode frfUnitUnknown{"frf_unit_unknown", ErrorKind::InputRejected,
                                          LT_TEXT("Engine", "The unit “{found}” is not known; expected {expected}.")};

inline constexpr ErrorCode frequencyUnitMissing{
    "frequency_unit_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "“{found}” names an angular frequency, and its unit is not stated. State --frequency-unit rad/s or hz.")};

inline constexpr ErrorCode frfNotAscending{
    "frf_not_ascending", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The frequencies do not ascend: {found} Hz follows {previous} Hz.")};

inline constexpr ErrorCode frfVariablesUnknown{
    "frf_variables_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The variables cannot be told: found {found}, expected {expected}. Name them as f=NAME,H=NAME.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode frfSetsSkipped{
    "frf_sets_skipped", Severity::Info,
    LT_TEXT("Engine",
            "{path}: {count} functions are no frequency responses of a motion ({reason}), the first at line "
            "{line}.")};

inline constexpr NoteCode frfLabelContradictsUnit{
    "frf_label_contradicts_unit", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: “{label}” is stated in {unit}, which is {quantity}; the unit rules ({count} times, "
            "first at line {line}).")};

inline constexpr NoteCode frfForceAssumed{
    "frf_force_assumed", Severity::Warning,
    LT_TEXT("Engine", "{path}: no unit of the force is stated; read as N ({count} times, first at line {line})."),
    NoteRole::Assumed};

inline constexpr NoteCode frfUnitNotUsed{
    "frf_unit_not_used", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: the file states {unit}; the given unit {given} is not used ({count} times, first at "
            "line {line}).")};

inline constexpr NoteCode frfDrivingPointSign{
    "frf_driving_point_sign", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: the receptance of driving point {node} has a positive imaginary part in {percent} % of "
            "its lines; a direction, a unit or the sign of time is stated wrongly ({count} times, first at "
            "line {line}).")};

inline constexpr NoteCode frfUnitReplaced{
    "frf_unit_replaced", Severity::Info,
    LT_TEXT("Engine",
            "{path}: the unit {unit} is not known; the given unit {given} is used ({count} times, first at line "
            "{line}).")};

inline constexpr NoteCode frfTurned{
    "frf_turned", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: as that of a driving point {response} has the wrong sign: at {frequency_hz} Hz its receptance has "
            "a positive imaginary part, and its phase falls with the frequency. Hammer or sensor was turned round, or "
            "a direction or the kind of motion is stated wrongly. Multiply it by -1; depths and speeds by it are "
            "wrong.")};

inline constexpr NoteCode frfConjugated{
    "frf_conjugated", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: {response} is conjugated: its phase rises through the resonance at {frequency_hz} Hz, as under "
            "exp(-iωt). Change the sign of its imaginary part; depths and speeds by it are wrong.")};

inline constexpr NoteCode frfLinesDropped{
    "frf_lines_dropped", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: frequency lines without finite values, left out: {lines} ({count} times, first at line "
            "{line}).")};

inline constexpr NoteCode frfCoherenceUnused{
    "frf_coherence_unused", Severity::Info,
    LT_TEXT("Engine",
            "{path}: {count} coherence functions fit the lines of no frequency response, the first at line "
            "{line}.")};

inline constexpr NoteCode severalResponses{
    "several_responses", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: it holds {count} frequency responses; that of {used} (response/force) is used, not {others}. "
            "State --response to use another.")};

inline constexpr NoteCode noDrivingPoint{
    "no_driving_point", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: none of its responses is that of a driving point, where response and force share node and "
            "direction. That of {used} is a cross response: depths and speeds by it are not those of the cutting "
            "point.")};

inline constexpr NoteCode uffTextOutside{
    "uff_text_outside", Severity::Info,
    LT_TEXT("Engine", "{path}: lines of text outside the data sets, not used: {count}, the first at line {line}.")};

inline constexpr NoteCode uffDataBeyond{
    "uff_data_beyond", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: {count} data sets hold more than their declared points, which were read, the first at "
            "line {line}.")};

}  // namespace notes

}  // namespace lathelier
