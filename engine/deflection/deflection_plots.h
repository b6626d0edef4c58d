// Deflection as charts and tables, for screen and paper.
#pragma once

#include <optional>
#include <span>

#include "engine/deflection/compensation.h"
#include "engine/deflection/deflected_shape.h"
#include "engine/deflection/feed_adjustment.h"
#include "engine/deflection/identification.h"
#include "engine/deflection/what_if.h"
#include "engine/report/chart.h"
#include "engine/report/document.h"

namespace lathelier::deflection {

/// Optional parts of the error chart.
struct ErrorPlotParts {
    const ErrorBand* band = nullptr;                  ///< 95 % of the final error
    const CompensationResult* corrected = nullptr;    ///< error of the corrected program
    std::optional<double> tolerance_um;               ///< symmetric limits ±
    std::span<const ComparedDiameter> measured = {};  ///< points
};

/// Diameter error along z: each pass, and the final contour where there are several.
report::Plot errorPlot(const DeflectionResult& result, const ErrorPlotParts& parts = {}, const Language& language = {});

/// Forces of one pass along z.
report::Plot forcesPlot(const PassResult& pass);

/// Power at the cutting speed along z, one curve a pass.
report::Plot powerPlot(const DeflectionResult& result, double cutting_speed_m_min, const Language& language = {});

/// Depth of cut along z, one curve a pass.
report::Plot depthPlot(const DeflectionResult& result, const Language& language = {});

/// The handle of shapePlot().
inline constexpr const char* toolKey = "tool";

/// The deflected axis in both directions, with the tool as a handle to drag along z.
report::Plot shapePlot(const DeflectedShape& shape);

/// Correction on diameter at each corner.
report::Plot correctionPlot(const CompensationResult& result, const Language& language = {});

/// The feed that holds the tolerance, toward each place.
report::Plot feedPlot(const FeedResult& result);

report::Table sensitivityTable(const std::vector<Sensitivity>& swings);
report::Table diameterTable(const IdentificationResult& result);
report::Table robustnessTable(const std::vector<RobustnessRow>& rows);

}  // namespace lathelier::deflection
