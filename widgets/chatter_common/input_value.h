// An input of a Chatter panel as a value, from a file or from an item of the project.
#pragma once

#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/frf.h"
#include "engine/core/input_file.h"
#include "engine/project/project.h"
#include "engine/receptance/shaft_receptance.h"
#include "engine/receptance/spindle_receptance.h"
#include "engine/shaft/shaft.h"
#include "engine/task/inputs.h"

namespace lathelier::chatter_common {

inline constexpr const char* frfRole = "frf";
inline constexpr const char* shaftRole = "shaft";
inline constexpr const char* spindleRole = "spindle";

/// A value with its origin for the report.
template <class T>
struct InputValue {
    T value;
    InputFile input;         ///< description of the file or item for the report
    Notes notes;             ///< notes of the reader
    bool synthetic = false;  ///< true: marked as synthetic
};

/// Adds input, notes and the synthetic mark to the outcome and returns the value.
template <class Outcome, class T>
T recordInput(Outcome& outcome, InputValue<T> taken)
{
    outcome.inputs.push_back(std::move(taken.input));
    outcome.notes.insert(outcome.notes.end(), taken.notes.begin(), taken.notes.end());
    outcome.synthetic |= taken.synthetic;
    return std::move(taken.value);
}

/// Nothing when the input is not given. Errors: loadShaft(), loadSpindle(); itemNotThere. Thread-safe.
std::optional<InputValue<Shaft>> takeShaft(const project::PanelState& state, Stores& stores, const Progress& progress);
std::optional<InputValue<receptance::SpindleReceptance>> takeSpindle(const project::PanelState& state, Stores& stores,
                                                                     const Progress& progress);

/// A receptance that another panel made. None when the input is not given or is a file, whose response is selected by
/// the panel. Error itemNotThere.
std::optional<InputValue<Frf>> takeResponseItem(const project::PanelState& state);

/// A receptance with a key that identifies it.
struct ResponseInput {
    InputValue<Frf> taken;
    std::string basis;  ///< cache key: equal for equal bytes and import options
};

/// The item, or the first response of the file, with notes on its plausibility and on the other responses in the file.
/// None when the input is not given. Errors: readFrf(); itemNotThere. Thread-safe.
std::optional<ResponseInput> takeResponse(const project::PanelState& state, Stores& stores, const Progress& progress);

}  // namespace lathelier::chatter_common
