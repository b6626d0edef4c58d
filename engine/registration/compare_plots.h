// The pictures of a comparison: map, curves along the axis, histogram.
#pragma once

#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier::registration {

/// Deviations over length and angle: with the tolerance band in green, or plain, which shows the form of the error also
/// within the band. result.unrolled has to be there.
ColourMap unrolledMap(const CompareResult& result, bool with_tolerance);

/// Mean deviation along the axis with its scatter and the tolerance. result.meridian has to be there.
Plot deviationAlongAxis(const CompareResult& result);

/// Half section of the original and of the copy, whose deviation is drawn larger by magnification().
Plot magnifiedMeridian(const CompareResult& result, const Language& language = {});

/// How many times larger the deviation is drawn: 1, 2 or 5 × 10^n, at least 1.
double magnification(const CompareResult& result);

Plot histogramPlot(const CompareResult& result);

/// The limit of the colour scale: readable, most deviations of the map within it, and room beyond the tolerance band.
double colourLimit_mm(const CompareResult& result, bool with_tolerance = true);

}  // namespace lathelier::registration
