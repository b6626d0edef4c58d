// How much CYLt(MZCY) changes when the points are measured again.
// Source: JCGM 101 (propagation of distributions by Monte Carlo).
#pragma once

#include "engine/form/cylinder/cylinder_least_squares.h"

namespace lathelier::form {

/// Expanded uncertainty (95 %) of the width of the minimum zone, in the points' own unit of length, for independent
/// noise of standard deviation `sigma` on every point. Noise is laid on the form without noise: the waves around (to 8
/// UPR) and along (to the third degree) that stand out of it. The zones of the draws are linear about `fit`.
/// Deterministic. Throws Cancelled.
double expandedUncertaintyOfWidth(const CylinderPoints& points, const LeastSquaresCylinder& fit, double sigma,
                                  const Progress& progress);

}  // namespace lathelier::form
