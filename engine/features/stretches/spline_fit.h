// Teeth about the circle, the same along the axis: splines, serrations, straight gears.
#pragma once

#include <optional>

#include "engine/features/stretches/section_shape.h"

namespace lathelier::features {

/// The number of teeth is the highest whose pitch, folded over all of them, explains the radius as well as any. None
/// unless the folded profile explains nearly all of it, has one tooth a pitch, is no wave of form and its teeth are
/// alike. The crest is the median of the points on it; a width is stated where the flanks are parallel planes.
/// `mark.uncertainty_mm`: of the crest diameter, from the scatter of the teeth.
std::optional<FoundShape> splineOf(const StretchPoints& points);

}  // namespace lathelier::features
