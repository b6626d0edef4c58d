// Marks in the main view of a shaft.
#pragma once

#include <vector>

#include "engine/drawing/drawing.h"
#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

/// A stretch that is no body of revolution about the common axis: prism or eccentric. Its outline in the view.
struct ShapedStretch {
    double from_z_mm = 0, to_z_mm = 0;
    double low_mm = 0, high_mm = 0;                        ///< its silhouette, from the axis
    std::vector<double> edges_mm = {};                     ///< further edges along the axis
    std::vector<std::pair<double, double>> faces_mm = {};  ///< flat faces, between two heights: crossed diagonals
    std::optional<double> axis_mm = {};                    ///< height of its own axis
};

std::vector<ShapedStretch> shapedStretches(const Shaft& shaft);

/// Keyways, flats, holes, bolt circles, splines, prisms and eccentrics. `bored`: the upper half is cut away.
void addMarkLines(Drawing& view, const Shaft& shaft, double factor, bool bored);

/// What texts in the view are to keep clear of, in mm on paper.
std::vector<Box> markBoxes(const Shaft& shaft, double factor);

}  // namespace lathelier::drawing
