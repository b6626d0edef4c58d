// The meridian of a shaft as a polyline, for its pictures.
#pragma once

#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier::receptance {

/// Upper contours of the outside and of the bore, from the free end to the chuck; arcs as short chords.
struct ShaftContour {
    std::vector<double> z_mm, radius_mm, bore_mm;
    double largest_mm = 0;  ///< largest radius
};

ShaftContour contourOf(const Shaft& shaft);

}  // namespace lathelier::receptance
