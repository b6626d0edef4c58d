// The path of the imaginary tip of a rounded nose along a contour. Internal to the room.
#pragma once

#include <optional>
#include <vector>

#include "engine/gcode/cycles.h"
#include "engine/gcode/path_builder.h"

namespace lathelier::gcode {

/// As path_builder.h compensates it, begun and ended perpendicular to the contour; the first piece leads to its start.
/// None: the nose does not fit.
std::optional<std::vector<ContourPiece>> nosePath(const std::vector<ContourPiece>& contour, NoseSide side,
                                                  double radius_mm, int tip);

}  // namespace lathelier::gcode
