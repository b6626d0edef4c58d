// A shaft with its bores as stated, from a file or an item of the project: an input of Drawing and Compare.
#pragma once

#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/project/project.h"
#include "engine/shaft/shaft_item.h"
#include "engine/task/stores.h"

namespace lathelier::part_common {

struct PartInput {
    Shaft shaft;                             ///< the shaft; without a name named after the file
    InputFile input;                         ///< description of the file or item for the report
    Notes notes;                             ///< notes of the reader
    bool synthetic = false;                  ///< true: marked as synthetic
    std::optional<RecoveredFrom> recovered;  ///< for an item: the scan from which it was recognised
};

/// Errors: those of PartStore; itemNotThere. Thread-safe. Precondition: the input is given.
PartInput takePart(const project::PanelState& state, const std::string& role, Stores& stores, const Progress& progress);

}  // namespace lathelier::part_common
