// All that the map of residuals says of a recognised outside: offsets and lobes of its rows, correlation of the noise,
// and what remains unexplained. One pass over the points.
#pragma once

#include "engine/core/progress.h"
#include "engine/features/outline/dimensions.h"
#include "engine/features/recognition.h"
#include "engine/features/structure/residual_map.h"

namespace lathelier::features {

/// Data of one recognition.
struct StructureInput {
    const MeridianCloud& cloud;
    const Outline& outside;
    const Outline* bore = nullptr;  ///< none without one
    const SurfaceTable& surface;    ///< of the outside
    double form_mm = 0.02;          ///< form tolerance
};

/// The map with the lobes of its rows taken out.
struct PartStructure {
    ResidualMap map;              ///< of the outside
    double variance_ratio = 1;    ///< noise_correlation.h
    bool by_scatter = false;      ///< the ratio is χ² per bin: the model does not explain the bins
    double passes_um = 0;         ///< noise_correlation.h
    std::vector<RowLobes> lobes;  ///< of the rows in order of z
};

PartStructure structureOf(const StructureInput& input, const Progress& progress = {});

/// Puts lobes, unexplained structure and their notes into the result. z from the free end: `zero_mm` in the frame of
/// the outline. Precondition: rows and marks are there.
void describeStructure(const StructureInput& input, const PartStructure& structure, double zero_mm, Recognition& result,
                       const Progress& progress = {});

}  // namespace lathelier::features
