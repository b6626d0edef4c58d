// Where the numbers of a polar plot's rings stand, on the screen and on paper alike.
#pragma once

#include <optional>
#include <vector>

namespace lathelier::report {

/// A place in the drawing, seen from the plot's centre: x to the right, y upward.
struct PolarPlace {
    double x_px = 0, y_px = 0;
};

/// The number of a ring, and where its middle stands; nowhere when it has no room beside the numbers before it.
struct RingLabel {
    double radius_px = 0;
    double width_px = 0, height_px = 0;
    std::optional<PolarPlace> place{};
};

/// Places the labels on one ray between two of degrees: where least of what is drawn lies on them, and beside their
/// ring rather than on a curve that runs along it.
void placeRingLabels(std::vector<RingLabel>& labels, const std::vector<PolarPlace>& drawn, double rim_px);

}  // namespace lathelier::report
