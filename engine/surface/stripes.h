// The crests of one wave of a picture as lines, for visual comparison with the picture.
#pragma once

#include <array>
#include <vector>

#include "engine/surface/grid.h"

namespace lathelier::surface {

/// φ of the wave cos(2π k·x + φ) in the picture, in turns: 0 to 1. `frequency` k in cycles per pixel, x in pixels from
/// the middle of the upper left one. By the Fourier sum under a Hann window. Cost: one pass over the pixels.
double phaseOf(const Grid& flat, Vector frequency);

/// From edge to edge of the picture, in pixels from the upper left corner.
using Stripe = std::array<Vector, 2>;

/// The crests of the wave: lines where k·x + φ is whole, at most mostStripes of them (none if there are more).
inline constexpr int mostStripes = 2000;
std::vector<Stripe> stripesOf(Vector frequency, double phase, double width, double height);

}  // namespace lathelier::surface
