// Simultaneous fit of all lines of comb and lattice. In a small field several lines lie within the width of the window,
// and separate estimates would be biased toward neighbours: least squares over the amplitudes of all lines, inside a
// Levenberg-Marquardt search for the two wave vectors. Source: G. H. Golub and V. Pereyra, "The differentiation of
// pseudo-inverses and nonlinear least squares problems whose variables separate", SIAM J. Numer. Anal. 10 (1973).
#pragma once

#include <optional>

#include "engine/surface/significance.h"
#include "engine/surface/spectrum.h"

namespace lathelier::surface {

/// The wave vectors of feed marks and chatter, in cycles per pixel.
struct LatticeVectors {
    Vector feed{};         ///< K_f
    Vector chatter{};      ///< K_c
    double explained = 0;  ///< power of the samples explained by the lines
};

/// Lines l·K_c + j·K_f, |l| <= 4, of half the plane, around their expected positions. `noise`: also higher orders that
/// exceed it. None if the fit moves by more than a bin or does not converge.
std::optional<LatticeVectors> fittedLattice(const WindowedPicture& picture, Vector feed, Vector chatter,
                                            int iterations = 10, const Significance* noise = nullptr);

}  // namespace lathelier::surface
