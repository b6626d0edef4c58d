// A part as an input of the tasks draw and compare, from a file or an item of the project.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "engine/cad/part_input.h"
#include "engine/shaft/shaft_item.h"
#include "engine/task/inputs.h"

namespace lathelier::cad {

/// A part with where it comes from.
struct PartTaken {
    Shaft shaft;                                   ///< without a name named after the file
    std::shared_ptr<const Loaded<PartFile>> file;  ///< null: an item
};

/// Errors: those of PartInput; itemNotThere. Precondition: the input is given.
PartTaken takePart(const project::PanelState& state, const std::string& role, Stores& stores, task::Sources& sources,
                   const Progress& progress);

/// Adds to an error of checkShaft() the row's place in the file, and what the input is called.
void locatePart(Error& error, const project::Source& source);

/// Removes from the notes of the readers those that checkShaft() repeats.
void dropRepeated(task::Sources& sources, const Notes& remarks);

/// Is it a STEP file, or a SHAFT.json (an object with `segments`; with `command` it is a result), and so no scan?
/// `head`: the first io::headForKind bytes, or more.
bool isDrawing(std::string_view head);

}  // namespace lathelier::cad
