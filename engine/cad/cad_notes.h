// Features of a shaft that CAD files omit or represent differently.
#pragma once

#include "engine/core/error.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// Notes marksLeftOut and arcBeyondAxis, for whoever writes a CAD file of this shaft.
Notes cadNotes(const Shaft& shaft);

}  // namespace lathelier::cad
