// Connected regions of cells on a grid that may close around the axis.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::features {

/// Indices of the cells of each region, row by row: cells that share a side. `closed`: the last column neighbours the
/// first.
std::vector<std::vector<std::size_t>> connectedRegions(const std::vector<std::uint8_t>& taken, std::size_t columns,
                                                       bool closed);

/// Box of a region, in cells.
struct RegionBox {
    std::size_t first_row = 0, last_row = 0;        ///< of all rows
    std::size_t first_column = 0, last_column = 0;  ///< unwrapped: `last_column` may exceed the number of columns
    std::size_t rows() const { return last_row - first_row + 1; }
    std::size_t columns() const { return last_column - first_column + 1; }
};

/// A region that closes around the axis has all columns.
RegionBox boxOf(const std::vector<std::size_t>& region, std::size_t columns, bool closed);

/// Is the region about as long as wide, with empty corners? Sizes of a cell in mm.
bool isRound(const std::vector<std::size_t>& region, const RegionBox& box, double row_mm, double column_mm,
             double most_aspect, double most_fill);

}  // namespace lathelier::features
