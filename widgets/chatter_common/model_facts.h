// What was understood of the file of a shaft or a spindle, in the language of the screen.
#pragma once

#include <QString>
#include <string>

#include "engine/project/project.h"
#include "widgets/core/files/stores.h"

namespace lathelier::chatter_common {

/// For the input `role`, shaftRole or spindleRole; empty when the file was not read.
QString understoodModel(const std::string& role, const project::Source& source, Stores& stores);

}  // namespace lathelier::chatter_common
