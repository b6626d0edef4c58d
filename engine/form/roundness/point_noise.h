// What scatters about the form of a profile: noise of the points with its correlation, resolution and spikes.
// One record cannot tell form from noise by itself. What is assumed: form is the harmonics that stand out of their
// neighbours in the spectrum, and deviations that hold over five points or more; all else is noise of the measurement.
#pragma once

#include <optional>
#include <vector>

#include "engine/form/roundness/prepared_profile.h"
#include "engine/signal/harmonics.h"

namespace lathelier::form {

struct PointNoise {
    double sigma_um = 0;            ///< standard deviation of a point, without spikes; NaN: not known
    double beyond_rounding_um = 0;  ///< what of it is not the rounding to `resolution_um`
    double relative_u = 0;          ///< relative standard uncertainty of sigma_um
    double resolution_um = 0;       ///< step of the measured values; 0: none found, or the noise is stated
    double correlation_points = 1;  ///< neighbours that move together (integral scale); 1: independent
    std::vector<double> power_um2;  ///< mean square amplitude of order m of the sequence of points, m = 0…n/2, rounding
                                    ///< included; empty: independent points
    std::vector<double> spikes_um;  ///< single points that stand out by more than 6 standard deviations: how far
    std::vector<double> form_um;    ///< the form without noise at each prepared point, from prepared.radius_mm
    std::vector<double> floor_um;   ///< for each harmonic: amplitude that noise alone exceeds once in 3000
};

/// Step of the values in mm that all coordinates, or all radii about the origin, are multiples of; 0 below 20 nm.
double resolutionOf(const Profile& profile);

/// Splits the prepared profile into form and noise; `harmonics` in µm about prepared.centre_mm. Noise is at least that
/// of the resolution (step/√12). A `stated` standard deviation replaces what would be found, as independent noise. For
/// fewer than 32 points sigma_um is NaN unless stated.
PointNoise estimateNoise(const PreparedProfile& prepared, const std::vector<signal::Harmonic>& harmonics,
                         double resolution_mm, std::optional<double> stated_um, const Progress& progress = {});

}  // namespace lathelier::form
