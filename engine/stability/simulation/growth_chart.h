// The lobes over the growth that simulation finds at every point, and the two relations between speed and frequency
// with simulation as their referee.
#pragma once

#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_plots.h"

namespace lathelier::stability {

/// The limit over the growth per revolution, red where it grows and blue where it dies out; without a raster the
/// regions of lobesPlot().
report::Plot growthChart(const LobeResult& lobes, const RasterResult* raster, const OperatingPoint& point,
                         const Language& language = {});

/// The limits of both relations over the growth: what the papers' N = 60 f/k promises and what the simulation finds.
report::Plot comparisonChart(const LobeResult& exact, const LobeResult& published, const RasterResult* raster,
                             const OperatingPoint& point, const Language& language = {});

}  // namespace lathelier::stability
