// Texts of a place of the part, for the tag at the pointer and for the marker.
#pragma once

#include <QString>

#include "engine/cad/task/compare_places.h"

namespace lathelier::compare_panel {

/// "+0.053 mm"; "left out" without a value.
QString valueWords(const std::optional<double>& value_mm);

/// On one line: along and about the axis, or the coordinates where there is none.
QString placeWords(const cad::ComparePlace& place);

/// "+0.050 mm (limit 0.040)".
QString flagWords(const cad::CompareFlag& flag);

/// Deviation and mean, place about the axis, coordinates, each on its own line.
QString allWords(const cad::ComparePlace& place);

}  // namespace lathelier::compare_panel
