// Approximation of a contour by a minimal number of straight blocks with corners on a grid, within a tolerance.
//
// Among the places z₀ < z₁ < … the corners are chosen, and for each a radius on the grid, so that every straight line
// between neighbours passes every place in between within the tolerance. For a corner (z, x) the lines that do so have
// slopes in an interval that narrows from place to place (a cone); the shortest chain of corners follows by dynamic
// programming, among chains of equal length that with the least squares of distances at the corners. Cost: places ×
// reach of a line × grid radii within the tolerance (two or three). The places of an arc of the program are joined by
// arcs (written_arc.h).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/deflection/written_arc.h"

namespace lathelier::deflection {

/// A chosen corner.
struct WrittenCorner {
    std::size_t place = 0;           ///< index of the target point
    double x_mm = 0;                 ///< on the grid
    std::optional<ArcCentre> arc{};  ///< that leads here; none: a line
    friend bool operator==(const WrittenCorner&, const WrittenCorner&) = default;
};

/// Corners among `wanted`, whose first and last are always corners, as are those of `arcs`; z ascends strictly.
/// `limits` are of the radius. None: no grid radius lies within the tolerance at a corner.
std::optional<std::vector<WrittenCorner>> writtenContour(const std::vector<WantedPlace>& wanted,
                                                         const std::vector<WantedArc>& arcs, const ArcLimits& limits);

}  // namespace lathelier::deflection
