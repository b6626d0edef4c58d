// Reference circles as JSON, as scripts know them.
#pragma once

#include "engine/core/json.h"
#include "engine/form/circles.h"

namespace lathelier::form {

/// {"LSCI": {…}, "MZCI": {…}, "MICI": {…}, "MCCI": {…}}
Json toJson(const ReferenceCircles& circles);

}  // namespace lathelier::form
