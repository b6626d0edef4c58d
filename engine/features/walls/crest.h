// The crest of a rough surface, a thread or a knurl: the radius that its outermost points scatter about.
//
// Of all points some lie on the crest, the others below it; all have the scanner's noise. The density of the radii near
// the crest c is w φ(r - c) + a Φ(c - r) + b ∫Φ: a plateau, and a depth whose density changes linearly. w, a and b
// follow from c by weighted linear least squares over a histogram; c is the place of the least deviance.
#pragma once

#include <optional>
#include <vector>

#include "engine/features/walls/walls.h"

namespace lathelier::features {

struct Crest {
    double radius_mm = 0;  ///< from the axis
    double sigma_mm = 0;   ///< standard uncertainty
};

/// nullopt with fewer than 60 radii or without noise. `blur_mm`: width of an even spread that the radii have besides
/// their noise.
std::optional<Crest> crestOf(const std::vector<float>& radii, double sigma_mm, double blur_mm = 0);

/// The cone at the start of a rough zone, seen between the grooves only.
struct Lead {
    std::vector<Wall> walls;  ///< over its crests, 0.1 mm wide, in order of z; none: no such cone
    double reached_mm = 0;    ///< along the axis: here it reaches the crests of the zone
};

/// `border_mm`: where the zone begins; `toward_end`: it extends to larger z. The cone is at most `longest_mm` long and
/// ends at the radius `level_mm`.
Lead leadIn(const MeridianCloud& cloud, double border_mm, bool toward_end, double longest_mm, double level_mm,
            double sigma_mm);

}  // namespace lathelier::features
