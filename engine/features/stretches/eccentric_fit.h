// A circle beside the axis: a collar, a cam for an eccentric drive, a crank pin.
#pragma once

#include <optional>

#include "engine/features/stretches/section_shape.h"

namespace lathelier::features {

/// Robust least squares of the distances from a circle (Gauss and Newton, Tukey's weights, from the algebraic fit of
/// Kåsa, IEEE Trans. Instrum. Meas. 25, 1976). None unless nearly all points lie on it within their noise, its axis is
/// the same all along and off the common one. `mark.uncertainty_mm`: of the offset.
std::optional<FoundShape> eccentricOf(const StretchPoints& points);

}  // namespace lathelier::features
