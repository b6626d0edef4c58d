// How much RONt changes when the points are measured again.
// Source: JCGM 101 (propagation of distributions by Monte Carlo).
#pragma once

#include "engine/form/prepared_profile.h"

namespace lathelier {

/// Standard deviation of a point from the third differences of its neighbours, which form of few waves hardly moves;
/// robust against outliers and steps. NaN for fewer than 32 points.
double pointNoise_um(const PreparedProfile& prepared);

/// Amplitude that noise of the points alone hardly gives a harmonic (once in 3000).
double noiseFloor_um(double noise_um, std::size_t points);

/// Twice the root mean square by which noise of `noise_um` on the points, filtered as they were, changes RONt of the
/// form without noise (its harmonics that stand out): spread and the excess that extremes of noise always add. The fits
/// of the draws are linear about the circle found, which is exact to the square of the noise over the radius.
/// `harmonics` in µm about prepared.centre_mm. Deterministic.
double expandedUncertainty_um(const PreparedProfile& prepared, const std::vector<Eigen::Vector2d>& evaluated_mm,
                              const std::vector<Harmonic>& harmonics, const ProfileBand& band, ReferenceCircle which,
                              const FittedCircle& circle, double noise_um, const Progress& progress);

}  // namespace lathelier
