// Pictures of surfaces with the detected marks as overlay, for reports: SVG with embedded picture.
#pragma once

#include <string>
#include <vector>

#include "engine/core/texts.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// The length of a scale bar: 1, 2 or 5 times a power of ten, at most `largest`.
double roundBelow(double largest);

/// The flattened picture in grey with the crests of feed and chatter marks, rulers of the measured pitch and the stated
/// feed, and a scale bar, as SVG.
std::string markedPictureSvg(const ImageMarks& image, const SurfaceParameters& parameters,
                             const Language& language = {});

/// Before and after in the same scale, direction and grey, side by side, as SVG.
std::string comparisonSvg(const SurfaceResult& result, const std::vector<std::string>& names,
                          const Language& language = {});

}  // namespace lathelier::surface
