// The part of a comparison that follows from tolerance and scanner accuracy alone: asked again without registering
// again.
#pragma once

#include "engine/registration/compare.h"

namespace lathelier::registration {

/// Do `a` and `b` differ in nothing but what judge() takes: tolerance, pass percentage, scanner accuracy?
bool sameButVerdict(const CompareParameters& a, const CompareParameters& b);

/// Takes tolerance, pass percentage and scanner accuracy from `parameters` into the result and fills
/// within_tolerance_percent, verdict, distinguishable_from_scanner and the note notDistinguishable anew, from the
/// deviations of the used points. Distinguishable: the RMS deviation is more than a tenth above the scanner's standard
/// deviation, because a stated accuracy is hardly known better than that. A millisecond for a million points.
void judge(CompareResult& result, const CompareParameters& parameters, const Progress& progress = {});

}  // namespace lathelier::registration
