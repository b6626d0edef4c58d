// A shaft with its bores as they are stated, from a file or an item of the project: an input of Drawing and Compare.
#pragma once

#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/shaft_item.h"
#include "engine/project/project.h"
#include "widgets/core/files/stores.h"

namespace lathelier::part_common {

struct TakenPart {
    Shaft shaft;                             ///< of a file without a name: named after the file
    InputFile input;                         ///< the file, or the item as if it had been one
    Notes notes;                             ///< of the reading
    bool synthetic = false;                  ///< marked as made by a program
    std::optional<RecoveredFrom> recovered;  ///< of an item: the scan that it was recognised in
};

/// Errors: those of PartStore; itemNotThere. Safe from any thread. Precondition: the input is given.
TakenPart takePart(const project::PanelState& state, const std::string& role, Stores& stores, const Progress& progress);

}  // namespace lathelier::part_common
