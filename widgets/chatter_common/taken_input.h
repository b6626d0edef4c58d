// An input of a panel of the workspace Chatter as a value: from a file, or from an item of the project.
#pragma once

#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/frf.h"
#include "engine/core/input_file.h"
#include "engine/core/shaft.h"
#include "engine/project/project.h"
#include "engine/receptance/shaft_receptance.h"
#include "engine/receptance/spindle_receptance.h"
#include "widgets/core/files/stores.h"

namespace lathelier::chatter_common {

inline constexpr const char* frfRole = "frf";
inline constexpr const char* shaftRole = "shaft";
inline constexpr const char* spindleRole = "spindle";

/// A value with what a report says of where it came from.
template <class T>
struct Taken {
    T value;                 ///< from a file or an item
    InputFile input;         ///< the file, or the item as if it had been one
    Notes notes;             ///< of the reading
    bool synthetic = false;  ///< marked as made by a program
};

/// What a report says of `taken` goes to the picture; gives the value.
template <class Picture, class T>
T noted(Picture& picture, Taken<T> taken)
{
    picture.inputs.push_back(std::move(taken.input));
    picture.notes.insert(picture.notes.end(), taken.notes.begin(), taken.notes.end());
    picture.synthetic |= taken.synthetic;
    return std::move(taken.value);
}

/// The source of an input; nullptr: it is not given.
const project::Source* sourceOf(const project::PanelState& state, const char* role);

/// Nothing when the input is not given. Errors: loadShaft(), loadSpindle(); itemNotThere. Safe from any thread.
std::optional<Taken<Shaft>> takeShaft(const project::PanelState& state, Stores& stores, const Progress& progress);
std::optional<Taken<receptance::SpindleReceptance>> takeSpindle(const project::PanelState& state, Stores& stores,
                                                                const Progress& progress);

/// A table of the spindle says which frequencies there are: from its first line to its last.
receptance::ReceptanceParameters withinTable(receptance::ReceptanceParameters asked,
                                             const receptance::SpindleReceptance& spindle);

/// A receptance that another panel made. Nothing when the input is not given, or is a file: which of its responses
/// counts is the panel's to say. Error itemNotThere.
std::optional<Taken<Frf>> takeResponseItem(const project::PanelState& state);

/// A receptance with what tells it from another one.
struct TakenResponse {
    Taken<Frf> taken;
    std::string basis;  ///< the same for the same bytes, read in the same way
};

/// The item, or the first response of the file, with notes on what its shape says and on the others in the file.
/// Nothing when the input is not given. Errors: readFrf(); itemNotThere. Safe from any thread.
std::optional<TakenResponse> takeResponse(const project::PanelState& state, Stores& stores, const Progress& progress);

}  // namespace lathelier::chatter_common
