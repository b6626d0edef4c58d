// What a window says of files of responses, shafts and spindles.
#pragma once

#include <QString>

#include "engine/project/project.h"
#include "engine/task/stores.h"

namespace lathelier::chatter_common {

/// Facts of the file in the user's language; empty where no task has read it.
QString understoodModel(const project::Source& source, Stores& stores);

}  // namespace lathelier::chatter_common
