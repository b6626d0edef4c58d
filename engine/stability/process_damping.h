// Lobes of a cut with process damping: the contact of the tool flank with the surface wave damps the vibration at low
// speeds.
//
// Source: C. T. Tyler and T. L. Schmitz, "Analytical process damping stability prediction", J. Manuf. Processes 15
// (2013) 69: a force C (a/v) ẋ against the speed of the deflection, C in N/mm, a the depth of cut, v the cutting speed.
// With θ = ωT and v = πD/T the characteristic equation becomes 1/(aG) = -K_r (1 - cos θ) - i (K_r sin θ + C θ/(πD)): no
// speed but that in θ. Real and imaginary part give for each chatter frequency and lobe, with β = C/(πD K_r) and φ =
// θ/2 in (kπ, (k+1)π),
//   cot φ + β φ/sin²φ = cot(ε/2),   K_r a = sin²(ε/2) / (-2 Re G sin²φ),   N = 60 π f/φ
// which has two solutions or none: the process damping closes lobes at low speed. (The authors iterate instead.)
#pragma once

#include "engine/stability/envelope.h"

namespace lathelier::stability {

/// β = C/(π D K_r).
double dampingRatioOf(double process_damping_N_mm, double diameter_mm, double cutting_coefficient_N_mm2);

/// Lobe k with process damping; with β = 0 that of lobeCurve() for the exact relation.
LobeCurve dampedLobeCurve(const Boundary& boundary, int k, double beta);

}  // namespace lathelier::stability
