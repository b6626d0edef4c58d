// Growth per revolution over speed and depth, by simulation at every point: lobes checked by time-domain simulation.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/value.h"
#include "engine/report/chart.h"
#include "engine/stability/modes.h"

namespace lathelier::stability {

struct RasterParameters {
    double cutting_coefficient_N_mm2 = 2000;  ///< K_r
    Interval speed_rpm{1000, 4000};           ///< middles of the first and the last column
    Interval depth_mm{0, 1};                  ///< edges; the rows' middles lie within
    int columns = 200;
    int rows = 200;
    double direction_factor = 1;                      ///< D: the oriented receptance is D·G
    std::optional<double> process_damping_N_mm = {};  ///< C of F = C (a/v) ẋ; needs the diameter
    std::optional<double> diameter_mm = {};           ///< of the turned surface
};

struct RasterResult {
    RasterParameters parameters;
    std::vector<double> speed_rpm;
    std::vector<double> depth_mm;  ///< of the rows, ascending
    std::vector<float> growth;     ///< per revolution, row by row; above 1 chatter

    float at(std::size_t row, std::size_t column) const { return growth[row * speed_rpm.size() + column]; }
};

/// Parallel, with bit-identical results for any number of cores. Errors: valueNotUnderstood (no mode, fewer than 2
/// columns or rows, an empty range, a speed or damping that is no number above 0). Throws Cancelled.
RasterResult stabilityRaster(const std::vector<Mode>& modes, const RasterParameters& parameters,
                             const Progress& progress = {});

/// Colour map of ln(growth); 0 is the stability limit.
report::ColourMap rasterMap(const RasterResult& result);

}  // namespace lathelier::stability
