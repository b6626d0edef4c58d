// The exact cutting of a chain of walls into lines and arcs.
//
// Of all cuttings the one with the least sum of misfit and price, found by dynamic programming: F(j) = min over i < j
// of F(i) + cost(i, j) + β. Cost of a line: χ² = S_rr - S_zr²/S_zz. Cost of an arc: the algebraic circle q = Ax + By +
// C, q = x² + y², its residuals divided by 4ρ² and by the mean squared cosine of the normal, because the noise is
// radial. A flat
// arc longer than 30 mm is a parabola, whose least squares know no bias for radii of any size. Prices: 5 ln n for a
// line, 7.5 ln n for an arc. Up to two walls between two pieces may be left out, for 2 ln n each: points on both sides
// of a step of the radius lie in them, and neither piece explains their mean.
#pragma once

#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/features/walls/walls.h"

namespace lathelier::features {

/// Walls [begin, end) of a chain as one element.
struct Piece {
    std::size_t begin = 0, end = 0;                          ///< indices of walls, `end` excluded
    bool arc = false;                                        ///< an arc, else a line
    double level_mm = 0;                                     ///< line: radius at `at_mm`
    double slope = 0;                                        ///< line: dr/dz
    double at_mm = 0;                                        ///< line: mean z
    double slope_error = 0;                                  ///< standard uncertainty of the slope
    double centre_z_mm = 0, centre_r_mm = 0, radius_mm = 0;  ///< arc
    bool convex = false;                                     ///< arc: bulges away from the axis
    bool flat = false;  ///< arc: by a parabola; `level_mm` and `slope` are those of the arc at `at_mm`, its middle
};

/// O(n²) in the number of walls. Throws Cancelled.
std::vector<Piece> cutIntoPieces(std::span<const Wall> walls, const Progress& progress = {});

/// χ² of one piece over walls, as the cutting counts it: for tests against brute force.
double lineCost(std::span<const Wall> walls);
double arcCost(std::span<const Wall> walls);
double linePrice(std::size_t walls);
double arcPrice(std::size_t walls);
double leftOutPrice(std::size_t walls);

}  // namespace lathelier::features
