// Repeatability of CYLt(MZCY) under measurement noise. Source: JCGM 101 (propagation of distributions by Monte Carlo).
#pragma once

#include "engine/form/cylinder/cylinder_least_squares.h"

namespace lathelier::form {

/// Standard deviation of a point's noise in the points' own unit of length: the robust scatter of the distances about
/// the circumferential (to 8 UPR) and axial (to degree 3) form. Assumption: what that form does not explain is noise,
/// so that shorter waves count as noise. NaN for fewer than 272 points, which do not tell form and noise apart.
double estimatedNoise(const CylinderPoints& points, const LeastSquaresCylinder& fit, const Progress& progress);

/// Expanded uncertainty (95 %) of the width of the minimum zone, in the points' own unit of length, for independent
/// noise of standard deviation `sigma` on every point. Noise is added to the noise-free form: the significant
/// circumferential (to 8 UPR) and axial (to degree 3) terms. The zones of the draws are linearised about `fit`.
/// Deterministic. Throws Cancelled.
double expandedUncertaintyOfWidth(const CylinderPoints& points, const LeastSquaresCylinder& fit, double sigma,
                                  const Progress& progress);

}  // namespace lathelier::form
