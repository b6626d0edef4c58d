// Rows of shafts for tests.
#pragma once

#include <optional>

#include "engine/shaft/shaft.h"

namespace lathelier {

inline ShaftSegment shaftRow(double length_mm, double start_mm, double end_mm, std::optional<double> arc_mm = {})
{
    ShaftSegment row;
    row.length_mm = length_mm;
    row.start_diameter_mm = start_mm;
    row.end_diameter_mm = end_mm;
    row.arc_radius_mm = arc_mm;
    return row;
}

}  // namespace lathelier
