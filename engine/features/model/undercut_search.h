// Search for complete undercuts at the feet of shoulders.
#pragma once

#include "engine/core/progress.h"
#include "engine/features/model/model.h"

namespace lathelier::features {

/// At every foot of a shoulder whose last rows dip below the row before: a cone of 15°, a bottom and an arc into the
/// shoulder (DIN 509) in their place, where these suit the walls better by more than their price and a margin. With few
/// points the segmentation finds such rows as one arc. Returns the number inserted.
int tryUndercuts(Model& model, const Progress& progress = {});

}  // namespace lathelier::features
