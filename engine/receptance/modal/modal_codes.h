// Error and note codes of the modal fit, with their English patterns. {name} is replaced by the named value; text()
// prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode tooFewLinesToFit{
    "too_few_lines_to_fit", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{found} lines lie between {from_hz} and {to_hz} Hz; a modal fit needs at least {minimum}.")};

inline constexpr ErrorCode fitNeedsReceptance{
    "fit_needs_receptance", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "Modes are fitted to a receptance (displacement per force); convert the response first.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode modeNotResolved{
    "mode_not_resolved", Severity::Warning,
    LT_TEXT("Engine",
            "Mode at {frequency_hz} Hz: {lines} lines lie in its half-power band, at least {minimum} are needed to "
            "measure its damping. Use a finer frequency resolution.")};

inline constexpr NoteCode modeOutOfPhase{
    "mode_out_of_phase", Severity::Info,
    LT_TEXT("Engine",
            "Mode at {frequency_hz} Hz has a negative stiffness: force and motion are measured at places that move "
            "against each other, or a direction is reversed.")};

inline constexpr NoteCode modeUncertain{
    "mode_uncertain", Severity::Warning,
    LT_TEXT("Engine",
            "Mode at {frequency_hz} Hz is hardly determined by the data (stiffness ± {percent} %): fewer modes "
            "describe the response.")};

inline constexpr NoteCode fewerModes{
    "fewer_modes", Severity::Warning,
    LT_TEXT("Engine", "{asked} modes were asked for; the response between {from_hz} and {to_hz} Hz supports {found}.")};

inline constexpr NoteCode noModes{
    "no_modes", Severity::Warning,
    LT_TEXT("Engine", "Between {from_hz} and {to_hz} Hz no mode stands out of the noise.")};

inline constexpr NoteCode modesBeyond{
    "modes_beyond", Severity::Info,
    LT_TEXT("Engine",
            "A mode outside the fitted range takes part in the fit (near {frequency_hz} Hz); it stands for what lies "
            "there and is not measured.")};

inline constexpr NoteCode complexModes{
    "complex_modes", Severity::Info,
    LT_TEXT("Engine",
            "Real modes leave {real_percent} % of the response; modes whose residues have a phase are fitted, which "
            "leave {error_percent} %.")};

inline constexpr NoteCode fitLeavesMore{
    "fit_leaves_more", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The fit leaves {error_percent} % of the response, the scatter of its lines is {scatter_percent} %: the modal "
        "model does not describe it.")};

inline constexpr NoteCode fitNotConverged{"fit_not_converged", Severity::Warning,
                                          LT_TEXT("Engine", "The modal fit did not converge; judge it by its error.")};

}  // namespace notes

}  // namespace lathelier
