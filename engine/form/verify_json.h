// "Verify installation" as the command line prints it.
#pragma once

#include "engine/core/json.h"
#include "engine/form/verify.h"

namespace lathelier::form {

Json toJson(const VerifyResult& result);

}  // namespace lathelier::form
