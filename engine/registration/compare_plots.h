// The pictures of a comparison: map, curves along the axis, histogram.
#pragma once

#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier::registration {

/// Deviations over length and angle: with the tolerance band in green, or plain, which shows the form of the error also
/// within the band. result.unrolled has to be there.
report::ColourMap unrolledMap(const CompareResult& result, bool with_tolerance);

/// Mean deviation along the axis with its scatter and the tolerance. result.meridian has to be there.
report::Plot deviationAlongAxis(const CompareResult& result, const Language& language = {});

/// Half section of the original and of the copy, whose deviation is drawn `factor` times larger (default:
/// magnification()), with what is in excess and what is missing shaded, the tolerance and the zones left out.
/// result.meridian has to be there. The curves are excess, missing, original, copy, then the tolerance.
report::Plot magnifiedMeridian(const CompareResult& result, const Language& language = {},
                               std::optional<double> factor = {});

/// How many times larger the deviation is drawn: 1, 2 or 5 × 10^n, at least 1.
double magnification(const CompareResult& result);

/// Histogram with the normal curve of the same mean and scatter, at least from -limit_mm to limit_mm (default:
/// colourLimit_mm()). With a tolerance the bars are coloured by it, and its two limits are the handles "lower" and
/// "upper".
report::Plot histogramPlot(const CompareResult& result, const Language& language = {},
                           std::optional<double> limit_mm = {});

/// The limit of the colour scale: readable, most deviations of the map within it, and room beyond the tolerance band.
double colourLimit_mm(const CompareResult& result, bool with_tolerance = true);

}  // namespace lathelier::registration
