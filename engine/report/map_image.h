// A colour map as a picture with a palette, for paper.
#pragma once

#include "engine/report/chart.h"
#include "engine/report/png.h"

namespace lathelier::report {

/// Levels of the scale from -limit to +limit: an odd number, so that 0 is one of them.
inline constexpr int mapLevels = 255;

/// The colours of the levels, and white for places without data.
std::vector<Rgb> paletteOf(const ColourMap& map);

/// Whether the map has cells, a scale and an extent.
bool isDrawable(const ColourMap& map);

/// The highest row at the top; of a large grid the means of blocks. Precondition: isDrawable(map).
IndexedImage imageOf(const ColourMap& map);

}  // namespace lathelier::report
