// The pictures of a comparison: map, curves along the axis, histogram.
#pragma once

#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier {

/// Deviations over length and angle. result.unrolled has to be there.
ColourMap unrolledMap(const CompareResult& result);

/// Mean deviation along the axis with its scatter and the tolerance. result.meridian has to be there.
Plot deviationAlongAxis(const CompareResult& result);

/// Half section of the original and of the copy, whose deviation is drawn larger by magnification().
Plot magnifiedMeridian(const CompareResult& result, const Language& language = {});

/// How many times larger the deviation is drawn: 1, 2 or 5 × 10^n, at least 1.
double magnification(const CompareResult& result);

Plot histogramPlot(const CompareResult& result);

/// The limit of the colour scale: readable, and most deviations within it.
double colourLimit_mm(const CompareResult& result);

}  // namespace lathelier
