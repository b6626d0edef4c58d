// Which measured rows stand for which row of a drawing: the cheapest assignment in order of z.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/shaft.h"

namespace lathelier::features {

/// A row of either side, in the z of the drawing, toward larger z.
struct RowOnAxis {
    std::size_t index = 0;  ///< where it came from
    double z_start_mm = 0, z_end_mm = 0;
    double start_diameter_mm = 0, end_diameter_mm = 0;
    std::optional<double> arc_radius_mm;      ///< signed as ShaftSegment::arc_radius_mm
    SizeUncertainty uncertainty;              ///< of a measured row
    bool start_seen = true, end_seen = true;  ///< of a measured row: false where the data end before it does
    bool fully_visible = true;                ///< of a measured arc
};

/// Measured rows [first, first + count) that one of the drawing is; count 0: none was found.
struct RowRun {
    std::size_t first = 0, count = 0;
};

struct RowMatch {
    std::vector<RowRun> runs;  ///< one for each row of the drawing
    double cost_mm = 0;        ///< distances of ends and diameters, and the price of what is left over
};

/// Both in order of z.
RowMatch matchRows(const std::vector<RowOnAxis>& nominal, const std::vector<RowOnAxis>& measured);

}  // namespace lathelier::features
