// The crest of a rough surface, a thread or a knurl: the radius that its outermost points scatter about.
//
// Of all points some lie on the crest, the others below it; all have the scanner's noise. The density of the radii near
// the crest c is w φ(r - c) + a Φ(c - r) + b ∫Φ: a plateau, and a depth whose density changes linearly. w, a and b
// follow from c by weighted linear least squares over a histogram; c is the place of the least misfit.
#pragma once

#include <optional>
#include <vector>

#include "engine/features/walls.h"

namespace lathelier::features {

struct Crest {
    double radius_mm = 0;  ///< from the axis
    double sigma_mm = 0;   ///< standard uncertainty
};

/// nullopt with fewer than 60 radii or without noise. `blur_mm`: width of an even spread that the radii have besides
/// their noise.
std::optional<Crest> crestOf(std::vector<float> radii, double sigma_mm, double blur_mm = 0);

/// A cone that leads into a rough zone, seen between its grooves only: walls over its crests in bins of 0.1 mm, in
/// order of z, from the border of the zone to where they reach the radius `level_mm`. Fewer than three: none.
std::vector<Wall> leadIn(const MeridianCloud& cloud, double border_mm, bool toward_end, double longest_mm,
                         double level_mm, double sigma_mm);

}  // namespace lathelier::features
