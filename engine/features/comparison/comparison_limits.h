// Limits of the comparison of a recognised part with its drawing. Where no origin is stated, a value was chosen on the
// practice scans: synthetic scans of turned parts with known truth, worn ones among them.
#pragma once

#include <cstddef>

namespace lathelier::features {

/// Assignment of measured rows to those of the drawing (row_matching.h, rows_on_axis.h). Prices are lengths: they are
/// added to the distances of ends and diameters.
struct MatchingLimits {
    std::size_t longest_run = 16;  ///< measured rows for one of the drawing
    double run_diameter_mm = 0.5;  ///< largest distance of a run's diameters from the drawing's
    double run_arc_part = 5;       ///< of arcs, this part of that distance
    double extra_row_price_mm = 1e-3;
    double other_kind_price_mm = 0.3;                                  ///< an arc for a straight row, or the reverse
    double unassigned_price_mm = 0.2;                                  ///< of a row without a counterpart, and
    double unassigned_price_share = 0.25, longest_priced_row_mm = 20;  ///< of its length, at most this one
    double least_row_mm = 1e-6;
    double mark_mm = 1;            ///< least distance within which the middles of two marks are one place
    double joining_gap_mm = 0.05;  ///< rows no further apart join; bores no further from an end reach it
};

inline constexpr MatchingLimits matchingLimits;

/// Triangle meshes of shafts (shaft_mesh.h).
struct MeshingLimits {
    double finest_sagitta_mm = 2e-4;
    std::size_t most_triangles = 2000000;  ///< of the mesh of a drawing
    double no_radius_mm = 1e-9;            ///< smaller radii are on the axis
    int least_sides = 12;                  ///< of a circle of that mesh
    int least_chords = 3;                  ///< of an arc: with two, the point between them would exceed the sagitta
    double coarsening = 1.5;               ///< of the sagitta, until the triangles are few enough
};

inline constexpr MeshingLimits meshingLimits;

}  // namespace lathelier::features
