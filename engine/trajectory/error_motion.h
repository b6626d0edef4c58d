// Statistics over the revolutions of a section, and the error motion of a spindle by ISO 230-7.
#pragma once

#include <span>

#include "engine/trajectory/section_signals.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// Mean, standard deviation, extremes and confidence of the mean of one probe at each angle; NaN where there is no
/// value.
ProbeStatistics statisticsOf(const SectionSignals& signals, Probe probe);

/// Error motion of values in µm [revolution][angle] at `angle_deg` (any angles, at least three different ones): k = 0
/// and 1 of the mean curve, the setting of the probe and the eccentricity of the mandrel, are removed. `form_um`: of
/// what the probe looks at; part of the uncertainties. That of the synchronous motion is of the means at its two
/// extremes, that of the total motion is of the extremes of n independent revolutions, whose standard deviation is
/// π/√6 σ/√(2 ln n) each (E. J. Gumbel, "Statistics of Extremes", 1958).
ErrorMotion errorMotion(std::span<const double> values_um, std::span<const double> angle_deg, double form_um = 0);

/// The same for a mean curve alone, which does not determine asynchronous and total motion (NaN).
ErrorMotion errorMotionOfMean(std::span<const double> mean_um, std::span<const double> angle_deg);

/// Rotating sensitive direction: X cosθ + Y sinθ, with θ in the sense of rotation of the axis.
std::vector<double> rotatingDirection(std::span<const double> x_um, std::span<const double> y_um,
                                      std::span<const double> angle_deg);

}  // namespace lathelier::trajectory
