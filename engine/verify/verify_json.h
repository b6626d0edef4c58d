// "Verify installation" as the command line prints it.
#pragma once

#include "engine/core/json.h"
#include "engine/verify/verify.h"

namespace lathelier {

Json toJson(const VerifyResult& result);

}  // namespace lathelier
