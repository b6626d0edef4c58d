// Undercuts at the feet of shoulders, as a whole.
#pragma once

#include "engine/core/progress.h"
#include "engine/features/model.h"

namespace lathelier::features {

/// At every foot of a shoulder whose last rows dip below the row before: a cone of 15°, a bottom and an arc into the
/// shoulder (DIN 509) in their place, where these suit the walls better by more than their price and a margin. In thin
/// scans the cutting takes such rows for one arc. Gives how many were put in.
int tryUndercuts(Model& model, const Progress& progress = {});

}  // namespace lathelier::features
