// Overlays of the picture of a surface, in the user's language.
#pragma once

#include <vector>

#include "widgets/surface/picture_view.h"
#include "widgets/surface/shown_outcome.h"

namespace lathelier::surface_panel {

/// Preconditions: there are feed marks; chatter marks; such a line.
Overlay feedOverlay(const surface::ImageMarks& image, const ShownImage& shown);
Overlay chatterOverlay(const surface::ImageMarks& image, const ShownImage& shown);
Overlay lineOverlay(const surface::ImageMarks& image, int line);

/// The pitch that was found, and the feed that was stated.
std::vector<Ruler> rulersOf(const surface::ImageMarks& image, const surface::SurfaceParameters& parameters);

/// Across the marks, in the picture as evaluated.
double rulerDirection_deg(const surface::ImageMarks& image);

/// Result of the evaluation of a generated picture, as text.
QString foundWords(const ShownOutcome& outcome);

}  // namespace lathelier::surface_panel
