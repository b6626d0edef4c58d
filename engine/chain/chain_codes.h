// Errors and notes of the chain: codes with their English patterns. {name} is replaced by the named value.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode chainInputMissing{"chain_input_missing", ErrorKind::NoAnswer,
                                             LT_TEXT("Engine", "Not given: {what}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode measuredSizesCut{
    "measured_sizes_cut", Severity::Warning,
    LT_TEXT("Engine",
            "The drawing has the sizes of the worn part as they were measured. Suggested nominal sizes are in {file}: "
            "take them with --snap apply, or state a drawing.")};

inline constexpr NoteCode correctionRefused{
    "correction_refused", Severity::Warning,
    LT_TEXT("Engine", "The program cannot be corrected for deflection: {reason}")};

inline constexpr NoteCode chainFileChanged{
    "chain_file_changed", Severity::Warning,
    LT_TEXT("Engine", "{step}: {path} is no longer what it was when the chain was run.")};

inline constexpr NoteCode chainNumberChanged{
    "chain_number_changed", Severity::Warning,
    LT_TEXT("Engine", "{step}: a number of the dossier does not stand at {place} in {path}.")};

inline constexpr NoteCode speedBeforeAssumed{
    "speed_before_assumed", Severity::Info,
    LT_TEXT("Engine", "The photograph before is taken as cut at {speed_rpm} 1/min, the cutting speed of the job."),
    NoteRole::Assumed};

inline constexpr NoteCode marksAndModel{
    "marks_and_model", Severity::Info,
    LT_TEXT("Engine",
            "The marks before are of {frequency_hz} ± {uncertainty_hz} Hz, the model's chatter there of {model_hz} Hz: "
            "{difference_percent} % apart.")};

inline constexpr NoteCode marksDisagree{
    "marks_disagree", Severity::Warning,
    LT_TEXT("Engine",
            "The marks before are of {frequency_hz} ± {uncertainty_hz} Hz, the model's chatter there of {model_hz} Hz: "
            "{difference_percent} % apart. Machine, diameter, speed or number of waves may be wrong.")};

inline constexpr NoteCode fitRefused{"fit_refused", Severity::Warning,
                                     LT_TEXT("Engine", "Stiffness and forces cannot be fitted to the copy: {reason}")};

inline constexpr NoteCode predictionDisagrees{
    "prediction_disagrees", Severity::Warning,
    LT_TEXT("Engine",
            "The copy's diameters disagree with the prediction by more than both uncertainties: largest normalized "
            "error {normalized_error}.")};

}  // namespace notes

}  // namespace lathelier
