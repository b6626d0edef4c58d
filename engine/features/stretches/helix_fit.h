// Teeth that wind along the axis and are too deep for one wall: coarse threads, worms.
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/features/stretches/section_shape.h"

namespace lathelier::features {

/// Pitch, starts and hand are those whose profile, folded along the helix, explains most of the radius; of as good ones
/// the most starts. None unless it explains nearly all and the teeth are deep: shallow ones are found by
/// marks/periodic_mark.h. A worm has `designation` "m 2", its module of DIN 780. Throws Cancelled.
std::optional<FoundShape> helixOf(const StretchPoints& points, const Progress& progress = {});

}  // namespace lathelier::features
