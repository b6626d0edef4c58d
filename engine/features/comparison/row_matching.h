// Assignment of measured rows to the rows of a drawing: least cost, in order of z.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// A row of either side, in the z of the drawing, toward larger z.
struct RowOnAxis {
    std::size_t index = 0;                ///< where it came from
    double z_start_mm = 0;                ///< along the drawing
    double z_end_mm = 0;                  ///< no less than z_start_mm
    double start_diameter_mm = 0;         ///< at z_start_mm
    double end_diameter_mm = 0;           ///< at z_end_mm
    std::optional<double> arc_radius_mm;  ///< signed as ShaftSegment::arc_radius_mm
    SizeUncertainty uncertainty;          ///< of a measured row
    bool start_seen = true;               ///< of a measured row: false where the data begin after its start
    bool end_seen = true;                 ///< of a measured row: false where the data end before it does
    bool fully_visible = true;            ///< of a measured arc
};

/// The measured rows that one of the drawing is.
struct RowRun {
    std::size_t first = 0;  ///< index of the first of them
    std::size_t count = 0;  ///< 0: none was found
};

struct RowMatch {
    std::vector<RowRun> runs;  ///< one for each row of the drawing
    double cost_mm = 0;        ///< distances of ends and diameters, and the price of unassigned rows
};

/// Both in order of z.
RowMatch matchRows(const std::vector<RowOnAxis>& nominal, const std::vector<RowOnAxis>& measured);

}  // namespace lathelier::features
