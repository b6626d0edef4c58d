// What a drawing tells of the marks of a shaft: cross sections of keyways, flats, holes, bolt circles, prisms, splines
// and eccentrics, lengths to their places, and leaders for what is named only.
#pragma once

#include <vector>

#include "engine/drawing/features.h"
#include "engine/drawing/marks/mark_geometry.h"
#include "engine/drawing/size_texts.h"

namespace lathelier::drawing {

/// `outer`: the rows of the outside, `known`: their U by ContourRow::index; lengths of rows are in `features` already.
void addMarks(const Shaft& shaft, const std::vector<ContourRow>& outer, const std::vector<SizeUncertainty>& known,
              SizeTexts& texts, Features& features);

}  // namespace lathelier::drawing
