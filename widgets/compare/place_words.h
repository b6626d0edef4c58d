// Texts of a place of the part, for the tag at the pointer and for the marker.
#pragma once

#include <QString>

#include "engine/cad/task/compare_places.h"

namespace lathelier::compare_panel {

/// "+0.053 mm"; "left out" without a value.
QString valueWords(const std::optional<double>& value_mm);

/// On one line: along and about the axis, or the coordinates where there is none.
QString placeWords(const cad::ComparePlace& place);

/// Coordinates, place about the axis, deviation and mean, each on its own line.
QString allWords(const cad::ComparePlace& place);

}  // namespace lathelier::compare_panel
