// Lobes over the simulated growth at every point, and both relations between speed and frequency checked by simulation.
#pragma once

#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_plots.h"

namespace lathelier::stability {

/// The limit over the growth per revolution, red for growth, blue for decay; without a raster the regions of
/// lobesPlot().
report::Plot growthChart(const LobeResult& lobes, const RasterResult* raster, const OperatingPoint& point,
                         const Language& language = {});

/// The limits of both relations over the growth: the papers' N = 60 f/k against the simulation.
report::Plot comparisonChart(const LobeResult& exact, const LobeResult& published, const RasterResult* raster,
                             const OperatingPoint& point, const Language& language = {});

}  // namespace lathelier::stability
