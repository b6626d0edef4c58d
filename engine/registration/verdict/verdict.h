// The part of a comparison that follows from limits, rules and scanner accuracy alone: recomputed without a new
// registration.
#pragma once

#include "engine/registration/compare.h"

namespace lathelier::registration {

/// Do `a` and `b` differ in nothing but what judge() takes: tolerance, rules, zones, pass percentage, scanner accuracy?
bool sameButVerdict(const CompareParameters& a, const CompareParameters& b);

/// Without what judge() takes: equal for two that are sameButVerdict().
CompareParameters fittedOf(const CompareParameters& parameters);

/// Copies the parameters of the verdict into the result and recomputes scatter, zones, findings, worst place,
/// share within the limits, verdict, distinguishable_from_scanner and the notes about them from the deviations of
/// the used points and the local means (`windows`; without them the rule surface decides nothing). Distinguishable: the
/// RMS deviation is more than a tenth above the scanner's standard deviation, because a stated accuracy is known to
/// about 10 %. A few milliseconds for a million points. Error valueNotUnderstood for zones that overlap.
void judge(CompareResult& result, const CompareParameters& parameters, const Progress& progress = {});

}  // namespace lathelier::registration
