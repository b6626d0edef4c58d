// Separation of a profile into form and measurement noise, with the correlation, resolution and spikes of the noise.
// One record alone does not determine this. Assumption: form consists of the harmonics significantly above their
// neighbours in the spectrum and of deviations over five points or more; the rest is measurement noise.
#pragma once

#include <optional>
#include <vector>

#include "engine/form/roundness/prepared_profile.h"
#include "engine/signal/harmonics.h"

namespace lathelier::form {

struct PointNoise {
    double sigma_um = 0;            ///< standard deviation of a point, without spikes; NaN: not known
    double beyond_rounding_um = 0;  ///< the part of it that is not quantisation to `resolution_um`
    double relative_u = 0;          ///< relative standard uncertainty of sigma_um
    double resolution_um = 0;       ///< step of the measured values; 0: none found, or the noise is stated
    double correlation_points = 1;  ///< integral scale of the autocorrelation; 1: independent points
    std::vector<double> power_um2;  ///< mean square amplitude of order m of the sequence of points, m = 0…n/2, rounding
                                    ///< included; empty: independent points
    std::vector<double> spikes_um;  ///< deviations of single points beyond 6 standard deviations
    std::vector<double> form_um;    ///< the form without noise at each prepared point, from prepared.radius_mm
    std::vector<double> floor_um;   ///< for each harmonic: amplitude that noise alone exceeds once in 3000
};

/// Step of the values in mm that all coordinates, or all radii about the origin, are multiples of; 0 below 20 nm.
double resolutionOf(const Profile& profile);

/// Splits the prepared profile into form and noise; `harmonics` in µm about prepared.centre_mm. Noise is at least that
/// of the resolution (step/√12). A `stated` standard deviation replaces the estimate, as independent noise. For fewer
/// than 32 points sigma_um is NaN unless stated.
PointNoise estimateNoise(const PreparedProfile& prepared, const std::vector<signal::Harmonic>& harmonics,
                         double resolution_mm, std::optional<double> stated_um, const Progress& progress = {});

}  // namespace lathelier::form
