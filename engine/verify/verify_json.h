// "Verify installation" as the command line prints it.
#pragma once

#include "engine/core/json.h"
#include "engine/verify/verify.h"

namespace lathelier::verify {

Json toJson(const VerifyResult& result);

}  // namespace lathelier::verify
