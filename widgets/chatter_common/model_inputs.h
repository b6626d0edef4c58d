// Shafts and spindles as inputs of the Chatter panels.
#pragma once

#include <QString>
#include <string>

#include "engine/project/project.h"
#include "engine/task/stores.h"
#include "widgets/core/files/kind_finder.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier::chatter_common {

/// An input that is a file of this kind or an item.
InputRole inputRole(const char* role, Text label, Text hint, const io::FileKind& kind, const char* item);

/// An input that is a frequency response, measured or made by another panel; not required.
InputRole responseRole(Text hint);

/// Facts of the file of a response, in the user's language; empty when it was not read.
QString understoodResponse(const project::Source& source, Stores& stores);

/// Assigns files of shafts and spindles to their inputs.
void assignModels(project::PanelState& state, const std::vector<FoundFile>& files);

/// Facts of the file of the input `role` (shaftRole or spindleRole), in the user's language; empty when it was not
/// read.
QString understoodModel(const std::string& role, const project::Source& source, Stores& stores);

}  // namespace lathelier::chatter_common
