// A cross section with its axes, dimensions, letters and captions, its centre at 0, in mm on paper.
#pragma once

#include <string>

#include "engine/drawing/drawing.h"
#include "engine/drawing/marks/cross_section.h"

namespace lathelier::drawing {

/// The scale of a section beside a main view of this factor: the same where it can be read, else another of ISO 5455.
Scale sectionScale(const CrossSection& section, const Scale& main);

/// `title`: "A-A", "A-A (2:1)". Dimensions move outward until their texts meet nothing.
Drawing sectionDrawing(const CrossSection& section, const std::string& title, double factor, double height_mm);

}  // namespace lathelier::drawing
