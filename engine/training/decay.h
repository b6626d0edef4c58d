// Free decay of a vibration after an impulse, and the damping ratio from it.
//
// An impulse p on modes f_n, ζ, k gives x(t) = Σ (p ω_n²/k) e^{-ζ ω_n t} sin(ω_d t)/ω_d with ω_d = ω_n √(1-ζ²). Of one
// mode, n periods lower the amplitude from x₀ to x_n: the logarithmic decrement δ = ln(x₀/x_n)/n, and ζ = δ/√(4π² + δ²)
// (Inman, "Engineering Vibration", section 1.6).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/report/chart.h"
#include "engine/stability/modes.h"

namespace lathelier::training {

struct Decay {
    double step_s = 0;                  ///< sampling interval; the first sample is at the impulse
    std::vector<double> deflection_mm;  ///< at the point of the impulse
    double seconds() const { return step_s * static_cast<double>(deflection_mm.size()); }
};

/// Response to an impulse of 1 N·s with 96 samples per period of the highest mode. Preconditions: modes, all 0 < ζ < 1.
Decay ringDown(std::span<const stability::Mode> modes, double seconds);

/// A local maximum of the waveform.
struct Peak {
    double time_s = 0;         ///< after the impulse
    double deflection_mm = 0;  ///< from a parabola through three samples
};

/// The maxima above zero in order of time.
std::vector<Peak> peaksOf(const Decay& decay);

/// δ from the amplitudes before and after `periods`. Precondition: all > 0.
double logDecrement(double first_mm, double last_mm, int periods);

/// ζ of δ.
double dampingRatio(double log_decrement);

/// Deflection over the time.
report::Plot decayPlot(const Decay& decay);

}  // namespace lathelier::training
