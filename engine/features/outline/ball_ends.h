// Ends of the outside that are balls: an arc whose centre lies on the axis is closed by its own circle, up to the pole.
//
// Rays near the axis are lost, and those that graze the ball: its points end before the pole, as if it had a small
// flat.
#pragma once

#include <vector>

#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Ties the first and the last arc to the axis where the data allow it (Schwarz's criterion), the arc is seen to near
/// the pole and no face is. Sets Outline::balls.
void closeBallEnds(const OutlineInput& input, Outline& outline);

/// Puts the poles into the planes of these ends, with their uncertainty. Precondition: the outline is fitted.
void placePoles(Outline& outline);

/// Balls at the ends as marks, z in the frame of the rows. `rows`: those of the outside.
std::vector<ShaftMark> ballMarks(const Outline& outline, const std::vector<RecognizedRow>& rows);

}  // namespace lathelier::features
