// Repeatability of RONt under measurement noise. Source: JCGM 101 (propagation of distributions by Monte Carlo).
#pragma once

#include "engine/form/roundness/point_noise.h"

namespace lathelier::form {

/// Half-width of the interval about RONt that contains the noise-free value with 95 % probability. Noise with the
/// estimated spectrum and spikes is added to the noise-free form and filtered like the profile. Extremes of noise
/// always increase RONt, so the changes have a mean, which is included, and a spread, which includes that of the noise
/// estimate. The fits of the draws are linearised about the circle found, with an error of the order of noise² over
/// radius. NaN when the noise is unknown. Deterministic.
double expandedUncertainty_um(const PreparedProfile& prepared, const PointNoise& noise,
                              const signal::TransmissionBand& band, ReferenceCircle which, const FittedCircle& circle,
                              const Progress& progress);

/// Effect of an error of the nominal radius on RONt of deviations referred to it: an eccentricity e distorts by e²/4R
/// at 2 UPR, peak to valley twice that. 0 for profiles whose size is measured.
double nominalRadiusEffect_um(const Profile& profile, const PreparedProfile& prepared);

}  // namespace lathelier::form
