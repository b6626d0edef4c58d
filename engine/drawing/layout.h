// The view of a shaft with its dimensions at one scale, its origin on the axis at the free end.
#pragma once

#include <cstdint>

#include "engine/drawing/drawing.h"
#include "engine/drawing/features.h"

namespace lathelier::drawing {

/// How lengths from one end are shown (ISO 129-1).
enum class LengthStyle : std::uint8_t {
    Parallel,  ///< each on a lane of its own
    Chain,     ///< side by side on as few lanes as their texts allow
    Running,   ///< superimposed on one line, to save height; for lengths from the free end
};

/// Where sections stand.
enum class SectionPlace : std::uint8_t { Right, Below };

struct LayoutStyle {
    Scale scale;             ///< of the main view
    double height_mm = 3.5;  ///< of the lettering
    LengthStyle lengths = LengthStyle::Parallel;
    SectionPlace sections = SectionPlace::Right;
    double room_mm = 0;  ///< width for rows of sections below
};

/// `shaft` with its bores stated (withStatedBores), `features` of it.
Drawing layOut(const Shaft& shaft, const Features& features, const LayoutStyle& style);

}  // namespace lathelier::drawing
