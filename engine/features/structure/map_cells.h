// Cells of the residual map that are off the model, and cells without points.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/features/structure/residual_map.h"

namespace lathelier::features {

/// 1 where most points lie on another surface, or the mean is off by more than noise and form.
std::vector<std::uint8_t> offCells(const ResidualMap& map, double form_mm);

/// 1 where a cell holds hardly any points and its ring does; a window of three sectors bridges the pitch of the rays.
std::vector<std::uint8_t> emptyCells(const ResidualMap& map);

}  // namespace lathelier::features
