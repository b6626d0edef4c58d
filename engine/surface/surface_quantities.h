// The results of photographs described once: JSON, tables and CSV read this.
#pragma once

#include "engine/core/quantities.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

const std::vector<QuantityOf<FeedMarks>>& quantitiesOf(const FeedMarks*);
const std::vector<QuantityOf<ChatterMarks>>& quantitiesOf(const ChatterMarks*);
const std::vector<QuantityOf<ImageMarks>>& quantitiesOf(const ImageMarks*);
const std::vector<QuantityOf<SurfaceComparison>>& quantitiesOf(const SurfaceComparison*);

/// The keys `images` and `comparison` (null for one picture).
Json toJson(const SurfaceResult& result);

}  // namespace lathelier::surface
