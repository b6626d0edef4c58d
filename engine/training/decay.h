// The decay of a vibration after a blow, and the damping that it shows.
//
// A blow of the impulse p on modes f_n, ζ, k gives x(t) = Σ (p ω_n²/k) e^{-ζ ω_n t} sin(ω_d t)/ω_d with
// ω_d = ω_n √(1-ζ²). Of one mode, n periods lower the amplitude from x₀ to x_n: the logarithmic decrement
// δ = ln(x₀/x_n)/n, and ζ = δ/√(4π² + δ²) (Inman, "Engineering Vibration", section 1.6).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/report/chart.h"
#include "engine/stability/modes.h"

namespace lathelier::training {

struct Decay {
    double step_s = 0;                  ///< from sample to sample, the first at the blow
    std::vector<double> deflection_mm;  ///< of the point that was hit
    double seconds() const { return step_s * static_cast<double>(deflection_mm.size()); }
};

/// After a blow of 1 N·s, in 96 samples of the highest mode's period. Preconditions: modes, all 0 < ζ < 1.
Decay ringDown(std::span<const stability::Mode> modes, double seconds);

/// A highest point of the waveform between two samples.
struct Peak {
    double time_s = 0;         ///< from the blow
    double deflection_mm = 0;  ///< parabola through the three samples around it
};

/// The maxima above zero, in time.
std::vector<Peak> peaksOf(const Decay& decay);

/// δ from the amplitudes before and after `periods`. Precondition: all > 0.
double logDecrement(double first_mm, double last_mm, int periods);

/// ζ of δ.
double dampingRatio(double log_decrement);

/// Deflection over the time.
report::Plot decayPlot(const Decay& decay);

}  // namespace lathelier::training
