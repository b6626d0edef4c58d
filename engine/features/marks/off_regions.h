// Regions of the map (z, θ) where the points lie off the model.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Connected cells in which more than half of the points lie off the model.
struct OffRegion {
    std::vector<std::uint32_t> points;  ///< of the cells and of those beside them, off the model
    std::size_t cells = 0;
};

/// Run of the model at z; nullptr in gaps and rough zones.
const Run* smoothRunAt(const Model& model, double z_mm);

/// Regions of the outside. `bore`: points nearer to it are none; nullptr without one.
std::vector<OffRegion> offRegions(const MeridianCloud& cloud, const Model& model, const Outline* bore);

}  // namespace lathelier::features
