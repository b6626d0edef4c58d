// The poles of a computed response, which has no noise: relocated from a start until the response is that of its poles.
// Source: B. Gustavsen and A. Semlyen, "Rational approximation of frequency domain responses by vector fitting", IEEE
// Trans. Power Delivery 14 (1999) 1052: σ G and σ have the same poles, and the zeros of σ are the poles of G.
#pragma once

#include <vector>

#include "engine/core/frf.h"
#include "engine/core/progress.h"
#include "engine/stability/simulation/pole_basis.h"

namespace lathelier::stability {

/// Poles within the lines, by ascending frequency. `start`: natural frequencies with an estimate of their damping;
/// empty: the peaks of the response. Throws Cancelled.
std::vector<Pole> polesOf(const Frf& frf, std::vector<Pole> start, const Progress& progress = {});

}  // namespace lathelier::stability
