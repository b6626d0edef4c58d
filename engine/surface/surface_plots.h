// What photographs look like to the evaluation, as charts: the flattened picture with a ruler of the marks, its
// spectrum with comb and lattice ringed.
#pragma once

#include <string>

#include "engine/report/chart.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// The flattened picture, in mm where the scale is known; lines at the distance of the marks found and of the feed.
report::Plot markedPicture(const ImageMarks& image, const SurfaceParameters& parameters);

/// Decades of power over its surroundings, with rings about the lines of the comb and of the lattice.
report::Plot ringedSpectrum(const ImageMarks& image);

/// The brightness of the picture as evaluated, as a PNG file, at most 900 px wide.
std::string picturePng(const ImageMarks& image);

}  // namespace lathelier::surface
