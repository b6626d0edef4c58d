// How much RONt changes when the points are measured again.
// Source: JCGM 101 (propagation of distributions by Monte Carlo).
#pragma once

#include "engine/form/prepared_profile.h"

namespace lathelier {

/// Standard deviation of a point from the third differences of its neighbours, which form of few waves hardly moves;
/// robust against outliers and steps. NaN for fewer than 32 points.
double pointNoise_um(const PreparedProfile& prepared);

/// Twice the root mean square change of RONt about the reference circle when noise of `noise_um` is laid on the
/// measured points and filtered as they were. The fits of the draws are linear about the circle found, which is exact
/// to the square of the noise over the radius. Deterministic.
double expandedUncertainty_um(const PreparedProfile& prepared, const std::vector<Eigen::Vector2d>& evaluated_mm,
                              const ProfileBand& band, ReferenceCircle which, const FittedCircle& circle,
                              double noise_um, const Progress& progress);

}  // namespace lathelier
