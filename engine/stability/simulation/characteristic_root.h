// Growth of a vibration per revolution in closed form: the rightmost root of the characteristic equation.
//   1 + a G(s) [K_r (1 - e^{-sT}) + s C/v] = 0,  G(s) = Σ (ω/k)(ω + λs) / (s² + 2ζω s + ω²)
// Roots are found by Newton's method from starts along the imaginary axis, spaced more closely than the roots.
#pragma once

#include "engine/stability/simulation/growth.h"

namespace lathelier::stability {

/// Growth e^{Re(s) T} and frequency Im(s)/2π of the rightmost root. Precondition: at least one mode. Throws Cancelled.
Growth growthOfRoots(std::span<const Mode> modes, const CutForces& cut, double revolution_s,
                     const Progress& progress = {});

}  // namespace lathelier::stability
