// Selection of the places of a contour that get a length dimension.
#pragma once

#include <vector>

#include "engine/drawing/rows.h"

namespace lathelier::drawing {

/// A place that a length leads to.
struct Station {
    double z_mm = 0;         ///< along the axis
    double radius_mm = 0;    ///< the larger one of both sides
    std::size_t before = 0;  ///< position in the list of the row that ends there
};

/// Shoulders, ends of cylinders and tapers; of a groove the side of the larger neighbour (else that nearer to the
/// origin); of a chamfer or a radius between two cylinders without a face the end at the larger one; the last row's
/// end. In the order of travel.
std::vector<Station> stationsOf(const std::vector<ContourRow>& rows);

}  // namespace lathelier::drawing
