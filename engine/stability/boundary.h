// The stability boundary of a single-point cut over the chatter frequency, before a speed is chosen.
// Source: J. Tlusty; regenerative chatter with one direction: 1 + K_r a G(iω) (1 - e^{-iωT}) = 0. The real part gives
// a_lim = -1 / (2 K_r Re G); the phase gives the turns between the waves of two revolutions, k + ε/2π with
// ε = 3π + 2ψ, ψ = arg G.
#pragma once

#include <vector>

#include "engine/core/frf.h"

namespace lathelier::stability {

/// A point with negative real part, where the cut may chatter at this frequency.
struct BoundaryPoint {
    double frequency_hz = 0;     ///< of the chatter
    double compliance_mm_N = 0;  ///< -2 Re G > 0: the limiting depth is 1/(K_r compliance)
    double phase_turns = 0;      ///< ε/2π, in 0…1
};

/// Unbroken stretches of the frequency axis with Re G < 0, each of at least two points, ascending.
using Boundary = std::vector<std::vector<BoundaryPoint>>;

/// Between the lines of `frf` real and imaginary part are interpolated by cubics (Lagrange, four lines) with `steps`
/// points per interval where the response is not linear within 2e-5 of the depth; the values are multiplied by `factor`
/// (of the direction). Errors: notAReceptance, tooFewLines.
Boundary boundaryOf(const Frf& frf, double factor, int steps);

/// Omits points that linear interpolation over the frequency reproduces: depth to 2e-5, phase to 1e-6 turns, speed of
/// every lobe to 1e-6; `looser`: times these tolerances.
std::vector<BoundaryPoint> thinned(const std::vector<BoundaryPoint>& stretch, double looser = 1);

/// The value of the receptance at `frequency_hz` by that interpolation; the nearest line's outside.
std::complex<double> interpolated(const Frf& frf, double frequency_hz);

/// The minimum of the real part, refined between lines by the same cubic.
struct LeastRealPart {
    double frequency_hz = 0;
    double real_mm_N = 0;  ///< the minimum; ≥ 0: no chatter
    bool at_edge = false;  ///< it is the first or last line
};
LeastRealPart leastRealPart(const Frf& frf, double factor = 1);

}  // namespace lathelier::stability
