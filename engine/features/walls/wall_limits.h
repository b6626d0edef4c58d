// Limits and grids of the stages that turn points into walls and pieces of the meridian.
//
// Where no origin is stated, a value was chosen on the practice scans: synthetic scans of turned parts with known
// truth. Names end in the unit; `…_sigmas` are multiples of the noise of single points, `…_bins` of the bin width.
#pragma once

#include <cstddef>

namespace lathelier::features {

/// Walls and chains of walls (walls.h).
struct WallLimits {
    // Extent of the data along the axis.
    double density_step_mm = 0.25;             ///< points are counted in steps of this length
    std::size_t most_density_steps = 4000000;  ///< bounds the memory for a scan with one point far away
    double sparse_end_share = 0.1;  ///< of the median count: steps with less at an end hold stray points only

    // Clusters of radii in one bin.
    double cluster_gap_sigmas = 6;               ///< noise leaves no larger gap between radii of one wall
    double cluster_gap_mm = 0.3;                 ///< lower bound of that gap, for data with little noise
    std::size_t least_cluster_points = 4;        ///< of a cluster
    double low_share = 0.08, high_share = 0.92;  ///< quantiles between which the spread of a cluster is measured
    double compact_sigmas = 4.2;     ///< largest spread of a wall from noise, 1.5 times that of a normal distribution
    double compact_bins = 1.2;       ///< added for a slope of 45° over the bin
    double compact_mm = 0.15;        ///< added for the same slope over the scanner's spot
    double outlier_sigmas = 4;       ///< robust standard deviations about the median that enter the mean
    double least_sigma_share = 0.3;  ///< of the noise: lower bound of a cluster's own scatter

    // Sectors of a wall that a flat or a slot covers.
    std::size_t most_mark_sectors = 48, least_mark_sectors = 9;  ///< into which a bin with a mark is divided
    std::size_t points_per_mark_sector = 5;                      ///< mean
    std::size_t least_median_points = 3;                         ///< with fewer points a sector has no median
    double median_error_factor = 1.25;  ///< standard error of a median over that of a mean: √(π/2)
    double agreeing_errors = 3;         ///< standard errors by which a sector may differ from the wall
    std::size_t most_odd_sectors = 2;   ///< no more are explained by chance: then none is left out
    std::size_t least_kept_part = 4;    ///< when less than one in so many points would be kept, all are

    // Clusters that are no walls.
    double least_counted_points = 5;     ///< clusters with more points determine the usual coverage
    double apart_share = 0.45;           ///< of a cluster's sectors without points of the main wall: floor of a mark
    double least_apart_sectors = 3;      ///< of such a cluster
    double mark_coverage_share = 0.6;    ///< of the main wall's coverage: largest one of such a cluster
    double least_coverage_share = 0.35;  ///< of the usual coverage: clusters with less are dropped

    // Chains of walls.
    double few_share = 0.1;             ///< of the points of a neighbour: less may be the edge of its row of points
    double one_row_bins = 0.45;         ///< walls nearer along the axis than this are one row, where one has few points
    double next_wall_bins = 0.2;        ///< least distance of the next wall along the axis
    double chain_step_mm = 0.12;        ///< largest change of the radius between neighbours, of noise
    double chain_slope = 1.3;           ///< the same for each mm along the axis: more than a chamfer of 45°
    double chain_gap_bins = 2.6;        ///< a chain ends at a longer gap
    double chain_gap_mm = 1.2;          ///< lower bound of that gap
    std::size_t least_chain_walls = 3;  ///< of a chain
    double longest_face_mm = 1.5;    ///< scattered walls at a chain's end are points of a face; a rough zone is longer
    double groove_blur_bins = 1.5;   ///< the bins at an edge hold points of both levels
    double groove_fill_share = 0.4;  ///< of a gap in a chain: another chain that fills more of it is a narrow groove

    // Bores.
    double bore_wall_mm = 1;      ///< the outside lies at least so far outside a bore
    double bore_search_bins = 3;  ///< largest distance along the axis of the outer wall that is compared
    double bore_search_mm = 1;    ///< lower bound of that distance

    // Noise of single points.
    std::size_t least_noise_walls = 5;  ///< from which the noise is taken
    double quiet_share = 0.2;           ///< quantile of the walls' scatter that rough zones do not reach
    double quiet_ratio = 1.33;          ///< of the median to that quantile: above it rough zones determine the median
};

inline constexpr WallLimits wallLimits;

/// Steep flanks (steep_walls.h).
struct SteepLimits {
    double least_slope = 1.3;      ///< chains reach over less (WallLimits::chain_slope)
    double largest_slope = 6.5;    ///< 81°; steeper flanks have too few walls
    double uneven_share = 0.25;    ///< of the slope: largest difference between those to both neighbours; an arc of
                                   ///< 5 mm that is this steep has more
    double uneven_errors = 3;      ///< standard errors of that difference, added
    double quantile_share = 0.84;  ///< of an even spread of radii, between their 8 % and 92 % quantiles
    double least_fill = 0.5;       ///< of the spread that the slope explains: less is no flank
    std::size_t least_walls = 3;   ///< between two neighbours each
};

inline constexpr SteepLimits steepLimits;

/// Points of coarse meshes (mesh_points.h).
struct MeshLimits {
    double least_sagitta_mm = 5e-4;    ///< facets with less are flat enough
    double flat_sagitta_ratio = 2;     ///< to the usual sagitta: facets with more are flats of the part
    double face_normal_share = 0.02;   ///< radial share of the normal below which a facet lies across the axis
    double least_radius_share = 1e-3;  ///< of the largest radius: a facet that comes nearer to the axis has no angle
    double largest_span_rad = 2;       ///< facets that span more of the circle are no approximation of it
};

inline constexpr MeshLimits meshLimits;

/// Crests of rough zones (crest.h).
struct CrestLimits {
    std::size_t least_radii = 60;                 ///< for the density of the radii
    double outer_sigmas = 5, inner_sigmas = 2.5;  ///< range of the histogram about the densest place
    double bins_per_sigma = 4;                    ///< of the histogram
    double densest_width_sigmas = 2;              ///< window that is moved over the radii to find the starting value
    double least_blur_sigmas = 0.05;              ///< a narrower even spread is not integrated over
    int weight_rounds = 4;                        ///< of the weighted least squares for the parts' weights
    double least_expected = 0.02;                 ///< count of a bin, so that its weight stays finite
    double search_step_sigmas = 0.25;
    int search_rounds = 5, search_steps = 8;  ///< each round a fourth as wide, so many steps to each side
    double curvature_step_sigmas = 0.1;       ///< for the second derivative of the deviance at its minimum

    // The cone that leads into a rough zone.
    double lead_bin_mm = 0.1;       ///< width of its walls
    double lead_level_mm = 0.03;    ///< a crest nearer to that of the zone ends it
    double lead_margin_mm = 0.15;   ///< at its upper end, where the spot shows the zone as well
    double assumed_spot_mm = 0.15;  ///< of the practice scans; the width is not known at this stage
    double lead_group_mm = 0.6;     ///< length over which points are put together for one crest
    int least_lead_groups = 3;      ///< of a cone that leads in
    double shortest_lead_mm = 0.2;
    double least_lead_slope = 0.1;    ///< of such a cone
    std::size_t least_lead_bins = 3;  ///< of such a cone
    double lead_inner_share = 0.5;    ///< of the zone's radius: points nearer to the axis are no part of it
    double lead_outer_mm = 1;         ///< nor are those further outside it
    double point_error_factor = 2.5;  ///< lower bound of a crest's error over that of the mean of all points
    double crest_error_factor = 1.7;  ///< allows for the unknown share of the points on the crest
    int lead_rounds = 4;              ///< slope and level follow from each other
};

inline constexpr CrestLimits crestLimits;

/// Cutting into lines and arcs (segmentation.h).
struct SegmentationLimits {
    double line_price = 5;     ///< times ln n: 2.5 for each of the two parameters, as in the later selection
    double arc_price = 7.5;    ///< times ln n: of three parameters
    double omitted_price = 2;  ///< times ln n, of each wall between pieces that is left out
    std::size_t least_line_walls = 3, least_arc_walls = 5;  ///< of a line and of an arc
    std::size_t most_omitted_walls = 2;                     ///< between two pieces
    double form_floor_mm = 1e-3;             ///< standard deviation of the walls' form besides their noise; with
                                             ///< 3 µm an undercut DIN 509-E 0.6×0.2 became one arc
    double longest_circle_mm = 30;           ///< along the axis: longer arcs are tried only where a parabola is better
                                             ///< than the line by their price, which bounds the time
    double flat_chord_share = 0.05;          ///< of the radius: such a long arc is a parabola to 1e-7 of its chord
    double least_mean_square_cosine = 0.02;  ///< of an arc's normal: steeper arcs are not seen along the radius
};

inline constexpr SegmentationLimits segmentationLimits;

}  // namespace lathelier::features
