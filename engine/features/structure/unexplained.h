// What the rows and marks of a recognition do not explain: regions where the residuals of the points differ from the
// model by more than noise and form tolerance, places without points on a wall or face that is seen, zones too rough
// for a row.
//
// A cell of the residual map is judged against the scatter of all cells about the median of their ring, which holds the
// noise with whatever correlation it has; what is the same all around is a matter of the meridian, not of this map.
// Only round places without points count as holes: others are taken for what the scanner did not see.
#pragma once

#include <vector>

#include "engine/features/recognition.h"
#include "engine/features/structure/residual_map.h"

namespace lathelier::features {

/// Thresholds of the search.
struct StructureThresholds {
    double sigmas = 6;            ///< of the mean of a cell; one cell in 10⁹ of pure noise
    double least_points = 4;      ///< of a cell that is judged
    std::size_t least_cells = 2;  ///< of a region; one cell alone may be an edge of a mark
    double least_far = 3;         ///< points on another surface that make a cell, when they are most of it
    double empty_share = 0.15;    ///< of the median of the ring's cells: less is empty
    double least_usual = 8;       ///< median of the points of three cells: fewer say nothing of empty ones
    double least_hole_mm2 = 3;    ///< area: a hole of 2 mm; below that a scanner loses points at random
    double most_aspect = 2;       ///< of a round region, cells are up to 1 mm wide
    double most_fill = 0.9;       ///< of its box: a circle fills π/4
    double most_missing = 0.03;   ///< share of cells without points: more is a scan with patches, where none is a hole
    double beside_mark_mm = 1.5;  ///< cells at the rim of a named mark belong to it
    double same_z_share = 0.5;    ///< regions whose stretches of z overlap so much are one structure
};
inline constexpr StructureThresholds structureThresholds{};

/// Structures of the outside, in order of z, in the frame of the outline. `marks`: named ones, in that frame; regions
/// that belong to them are explained. `form_mm`: lower deviations are form. Throws Cancelled.
std::vector<UnexplainedStructure> unexplainedOutside(const ResidualMap& map, const SurfaceTable& surface,
                                                     const Outline& outside, const std::vector<ShaftMark>& marks,
                                                     double form_mm, const Progress& progress = {});

}  // namespace lathelier::features
