// Placement of the ring labels of a polar plot, common to screen and paper.
#pragma once

#include <optional>
#include <vector>

namespace lathelier::report {

/// A place in the drawing, seen from the plot's centre: x to the right, y upward.
struct PolarPlace {
    double x_px = 0, y_px = 0;
};

/// The label of a ring and its centre; none when there is no space beside the earlier labels.
struct RingLabel {
    double radius_px = 0;
    double width_px = 0, height_px = 0;
    std::optional<PolarPlace> place{};
};

/// Places the labels on one ray between two of degrees: where they overlap the drawing least, and beside their ring
/// rather than on a curve along it.
void placeRingLabels(std::vector<RingLabel>& labels, const std::vector<PolarPlace>& drawn, double rim_px);

}  // namespace lathelier::report
