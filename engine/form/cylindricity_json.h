// Cylindricity as the command line prints it and the window writes it beside a report.
#pragma once

#include "engine/core/json.h"
#include "engine/form/cylindricity.h"

namespace lathelier::form {

/// The keys of the command line's `cylindricity`, without those every result has.
Json toJson(const CylindricityResult& result);

}  // namespace lathelier::form
