// What is drawn over the picture of a surface, in the language of the screen.
#pragma once

#include <vector>

#include "widgets/surface/picture_view.h"
#include "widgets/surface/surface_picture.h"

namespace lathelier::surface_panel {

/// Preconditions: there are feed marks; chatter marks; such a line.
Overlay feedOverlay(const surface::ImageMarks& image, const ShownImage& shown);
Overlay chatterOverlay(const surface::ImageMarks& image, const ShownImage& shown);
Overlay lineOverlay(const surface::ImageMarks& image, int line);

/// The pitch that was found, and the feed that was stated.
std::vector<Ruler> rulersOf(const surface::ImageMarks& image, const surface::SurfaceParameters& parameters);

/// Across the marks, in the picture as evaluated.
double rulerDirection_deg(const surface::ImageMarks& image);

/// What the evaluation says of a picture that was made.
QString foundWords(const SurfacePicture& picture);

}  // namespace lathelier::surface_panel
