// A drawing as one SVG file, in millimetres, self-contained, with attributes only (SVG Tiny 1.2), so that browsers, Qt
// and Inkscape show the same. The font is DejaVu Sans; where that is missing another sans serif. The sign ⌀ is written
// as Ø, since the font draws ⌀ no taller than a small letter. The same drawing gives the same bytes.
#pragma once

#include <string>

#include "engine/drawing/drawing.h"

namespace lathelier::drawing {

std::string toSvg(const Drawing& drawing);

}  // namespace lathelier::drawing
