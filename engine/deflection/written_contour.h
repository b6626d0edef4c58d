// Approximation of a contour by a minimal number of straight blocks with corners on a grid, within a tolerance.
//
// Among the places z₀ < z₁ < … the corners are chosen, and for each a radius on the grid, so that every straight line
// between neighbours passes every place in between within the tolerance. For a corner (z, x) the lines that do so have
// slopes in an interval that narrows from place to place (a cone); the shortest chain of corners follows by dynamic
// programming, among chains of equal length that with the least squares of distances at the corners. Cost: places ×
// reach of a line × grid radii within the tolerance (two or three).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace lathelier::deflection {

/// A point of the target contour.
struct WantedPlace {
    double z_mm = 0;
    double x_mm = 0;         ///< target radius
    bool is_corner = false;  ///< a corner is required here
    friend bool operator==(const WantedPlace&, const WantedPlace&) = default;
};

/// A chosen corner.
struct WrittenCorner {
    std::size_t place = 0;  ///< index of the target point
    double x_mm = 0;        ///< on the grid
    friend bool operator==(const WrittenCorner&, const WrittenCorner&) = default;
};

/// Corners among `wanted`, whose first and last are always corners; z ascends strictly. `grid_mm` and `tolerance_mm`
/// are of the radius. None: no grid radius lies within the tolerance at a corner.
std::optional<std::vector<WrittenCorner>> writtenContour(const std::vector<WantedPlace>& wanted, double grid_mm,
                                                         double tolerance_mm);

}  // namespace lathelier::deflection
