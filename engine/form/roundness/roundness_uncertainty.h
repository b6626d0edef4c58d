// How much RONt changes when the points are measured again.
// Source: JCGM 101 (propagation of distributions by Monte Carlo).
#pragma once

#include "engine/form/roundness/point_noise.h"

namespace lathelier::form {

/// Half-width of the interval about RONt that holds the value without noise in 95 of 100 measurements. Noise of the
/// kind found (its spectrum, its spikes) is laid on the form without noise and filtered as the points were; extremes of
/// noise always add to RONt, so the changes have a mean, which counts, and a spread, which holds that of the noise's
/// own estimate too. The fits of the draws are linear about the circle found, which is exact to the square of the noise
/// over the radius. NaN when the noise is not known. Deterministic.
double expandedUncertainty_um(const PreparedProfile& prepared, const PointNoise& noise,
                              const signal::TransmissionBand& band, ReferenceCircle which, const FittedCircle& circle,
                              const Progress& progress);

/// What an error of the nominal radius can do to RONt of deviations laid on it: a circle off by e is bent by e²/4R at
/// 2 UPR, peak to valley twice that. 0 for profiles whose size is measured.
double nominalRadiusEffect_um(const Profile& profile, const PreparedProfile& prepared);

}  // namespace lathelier::form
