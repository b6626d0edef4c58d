// The sections of a contour that paraxial passes clear one after the other. Internal to the room.
#pragma once

#include <vector>

#include "engine/gcode/level_contour.h"

namespace lathelier::gcode {

/// From `top` down to `bottom`: in front of the stretches that rise along the cut, and behind those that fall, if any.
struct Section {
    std::vector<Stretch> falling;  ///< from top to bottom; empty: the section is open at its front
    std::vector<Stretch> rising;   ///< from bottom to top
    double top = 0;
    double bottom = 0;
};

/// Pockets within pockets are followed to this depth.
inline constexpr int deepestPockets = 50;

/// The front with its pockets filled, then the pockets, each before those within it. A pocket that is open at the end
/// of the contour ends there with a wall. Empty: no contour, or pockets are nested deeper than deepestPockets.
std::vector<Section> sectionsOf(const std::vector<Stretch>& contour);

/// The stretch run backwards.
Stretch reversed(const Stretch& part);

/// The stretches displaced to the side of the stock: by `depth` along p, by `feed` along q away from each flank.
/// Empty: a pocket is narrower than that, or two flanks do not meet.
std::vector<Stretch> withAllowance(const std::vector<Stretch>& contour, double depth, double feed,
                                   const LevelAxes& axes);

/// The stretches as a contour, the first piece of which leads to its start.
std::vector<ContourPiece> contourOf(const std::vector<Stretch>& stretches, const LevelAxes& axes);

}  // namespace lathelier::gcode
