// Limits of the stages that make the outline: stretches between planes, places of the planes, wear, dimensions.
//
// Where no origin is stated, a value was chosen on the practice scans: synthetic scans of turned parts with known
// truth. Names end in the unit; `…_sigmas` are multiples of the noise of single points.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "engine/features/model/model_limits.h"

namespace lathelier::features {

/// Places of edges, faces and ends (edges.h).
struct EdgeLimits {
    double most_walls_beyond_mm = 0.3;  ///< of walls beyond the end that rows of rays show: three coarse bins
    // Edges from hits and misses of rays.
    double hit_probability = 0.997;  ///< of a ray clear of the edge; the others are spurious points
    std::array<double, 13> widths_mm{0.01, 0.02, 0.04, 0.06, 0.08, 0.1, 0.12,
                                     0.15, 0.18, 0.22, 0.28, 0.36, 0.5};  ///< tried for the spot
    std::size_t least_rays = 10;                                          ///< hits, and as many misses
    double ray_step_mm = 0.04;
    int ray_rounds = 7, ray_steps = 6;  ///< gridMaximum()
    std::ptrdiff_t gap_rays = 8;        ///< on each side: their largest gap is the pitch of the rows
    double density_reach_mm = 0.3;      ///< on each side, for the density of the rays
    double place_floor_mm2 = 1e-6;      ///< (1 µm)²

    // Faces.
    double least_noise_mm = 1e-3;                          ///< lower bound of the noise, for data without any
    double face_margin_sigmas = 6, face_margin_mm = 0.15;  ///< beside the two radii
    double face_reach_sigmas = 8, face_reach_mm = 0.3;     ///< on each side of the estimated place
    std::size_t least_face_points = 30, least_kept_face_points = 20;  ///< on a face, and those left without outliers
    double least_face_density = 3;       ///< the walls have no more than so many times the points per area
    double least_end_face_density = 10;  ///< of the face of an end, where no lower wall may be taken for it
    int face_rounds = 3;                 ///< of the removal of outliers
    double face_outlier_sigmas = 4;
    double largest_face_scatter_sigmas = 2;  ///< more is a slope
    double face_floor_mm2 = 2.5e-7;          ///< (0.5 µm)²

    // Ends from the last hits.
    double end_depth_mm = 5, end_depth_share = 0.8;  ///< length before the end that counts, at most that of the run
    double end_beyond_mm = 1;                        ///< estimated ends are no further off
    double end_wall_sigmas = 5;                      ///< hits are no further from the wall
    double steepest_end_slope = 2;                   ///< by which the spot is projected onto the radius
    std::size_t least_end_hits = 60, least_whole_hits = 40;  ///< near an end, and those in whole sectors
    double usual_hits_share = 0.75;                          ///< quantile of the sectors' hits that marks do not reduce
    std::size_t last_hits = 3;          ///< the last but two of a sector counts: stray points lie beyond
    std::size_t least_end_sectors = 3;  ///< with hits
    double whole_hits_share = 0.8;      ///< of the usual hits: a sector with less has a mark
    double whole_reach_mm = 0.6;        ///< nor does its last hit lie further from the median one
    double ramp_margin_mm = 0.4;        ///< before the last hits: the density is taken up to there
    double least_density_length_mm = 0.1;
    double assumed_spot_mm = 0.02;      ///< where none is known
    double least_ramp_density = 0.003;  ///< of the usual density, beyond the ramp: spurious points
    double end_step_mm = 0.05;
    int end_rounds = 7, end_steps = 8;  ///< gridMaximum()
    std::ptrdiff_t gap_hits = 20;       ///< before the end: their largest gap is the pitch of the rows
    double end_floor_mm2 = 36e-6;       ///< (6 µm)²
};

inline constexpr EdgeLimits edgeLimits;

/// Ends in the rows of a rotary scanner (end_rows.h).
struct EndRowLimits {
    // Hits.
    double depth_mm = 5, depth_share = 0.4;         ///< before the end, at most this share of the length
    double beyond_mm = 1;                           ///< estimated ends are no further off
    double band_step_mm = 0.02;                     ///< of the radii along the axis
    double assumed_spot_mm = 0.1;                   ///< where a smaller one is known
    double band_reach_mm = 0.05;                    ///< besides half the spot, the radii of which count as hits
    double band_sigmas = 5, band_margin_mm = 0.05;  ///< beyond them
    double below_root_mm = 0.6;                     ///< of a thread: its chamfer
    double upright_reach_mm = 0.3;  ///< before a round is upright: all radii down to its centre's are hits

    // Rows.
    double row_gap_mm = 0.004;  ///< a wider one parts two rows: coordinates are written to 0.001 mm
    std::size_t least_rows = 6;
    double least_row_hits = 3, least_row_share = 0.02;  ///< of the median row: fewer are spurious points
    double before_mm = 0.35;                            ///< besides the swing: rows so far before the last are whole
    std::size_t least_whole_rows = 4, most_whole_rows = 40;
    double usual_share = 0.75;  ///< quantile of the sectors' hits that marks do not reduce
    double whole_share = 0.5;   ///< of it: a sector with less does not count
    std::size_t least_sectors = 12;
    double reach_mm = 0.6;        ///< nor one whose hits end so far before the others'
    double pitch_quantile = 0.9;  ///< of the distances of rows: several passes lie irregularly
    std::size_t most_empty_rows = 200;

    // Likelihoods.
    double hit_probability = 0.997;  ///< of a ray clear of the edge; the others are spurious points
    double least_hit_share = 0.5;    ///< of the rays of a whole row
    double odd_cells = 0.02;         ///< share of the cells of row and sector that follow no model
    std::array<double, 6> widths_mm{0.01, 0.05, 0.1, 0.15, 0.2, 0.3};  ///< of the spot, equally likely
    double place_step_mm = 0.005;
    double place_floor_mm2 = 36e-6;  ///< (6 µm)²
    double tail_share = 0.001;       ///< of the posterior, on each side of the interval
};

inline constexpr EndRowLimits endRowLimits;

/// What closes an end (end_closure.h).
struct ClosureLimits {
    double decisive = 2.3;               ///< ln 10: ten to one decides
    double whole_scans = 1.1;            ///< ln 3: most scans show the end of the part, by judgement
    double shaped_ends = 0.8;            ///< share of parts that end in a chamfer or a round, by judgement
    double chamfer_half_angle_deg = 10;  ///< a cone that is steeper closes an end as a chamfer
    double missing_round_share = 0.2;    ///< of its radius: a round that ends so far before it is upright may go on
    double at_axis_mm = 0.5;             ///< an arc that ends no further from the axis reaches it
    double least_drop_sigmas = 3;        ///< a chamfer or round that is lower may be noise
    double least_drop_mm = 0.05;         ///< and so may one below this
    double least_length_mm = 0.25;       ///< or shorter
    double least_rows = 2;               ///< distances of rows of points that it holds
    std::size_t walls_for_pitch = 12;    ///< at the end, for that distance
    double gap_share = 0.5;              ///< of the largest gap between these walls: a larger one is between rows
    double reading_mm = 0.02;            ///< of a calliper (DIN 862): a stated length may be off by so much
};

inline constexpr ClosureLimits closureLimits;

/// Points that a scan loses beside edges (edge_loss.h).
struct EdgeLossLimits {
    double reach_mm = 1;            ///< points no further from a plane
    double wall_sigmas = 5;         ///< and from the model
    std::size_t least_points = 40;  ///< beside a plane
    std::size_t last_points = 3;    ///< the last but two counts: stray points lie beyond
    double assumed_mm = 0.1;        ///< where no plane shows it: that of the practice scans
};

inline constexpr EdgeLossLimits edgeLossLimits;

/// Which of these places each plane of an outline takes (plane_places.h).
struct PlaneLimits {
    // Radii beside a plane.
    double hollow_margin_mm = 0.3;          ///< a hollow that begins within this of the larger radius begins at it
    double hollow_depth_sigmas = 5;         ///< a hollow is the lower level where it is so deep
    double upright_reach_mm = 0.06;         ///< an arc that is upright no further from the plane ends there
    double room_mm = 1, room_share = 0.45;  ///< along the axis, at most this share of the runs beside it
    int radius_samples = 20;                ///< of a run beside a plane
    double least_shoulder_sigmas = 8;       ///< lower shoulders are placed as steps
    double least_ray_step_sigmas = 4;       ///< rays do not show lower ones
    double clear_sigmas = 7;                ///< noise fills 3.5 σ on each side of the gap between two walls
    double part_end_mm = 1;                 ///< a bore that ends no further from the outside's end ends there
    double part_end_floor_mm = 1e-4;
    double end_face_share = 0.55;     ///< of the radius: an end's face is looked for outside of it
    double surface_corner_mm = 0.16;  ///< walls of surface scans nearer to planes and corners do not count

    // Change points: steps, and ends of rough zones.
    std::size_t least_points = 40;  ///< beside a change point
    double least_spot_mm = 1e-3;
    double coarse_step_mm = 0.01;
    double negligible_log_ratio = 12;                  ///< places with less than e^-12 of the largest likelihood
    int fine_steps = 240;                              ///< of the posterior of a change point
    double place_floor_mm2 = 1e-6;                     ///< (1 µm)²
    double largest_log_ratio = 4.6;                    ///< 100 : 1, against spurious points
    double far_sigmas = 5;                             ///< points further from both walls do not count
    double step_reach_mm = 3, step_reach_share = 0.4;  ///< on each side, at most this share of the elements beside it
    double rough_reach_mm = 1.5, rough_reach_share = 0.3;  ///< the same, of the rough zone
    double rough_margin_mm = 0.5;                          ///< the histogram leaves out its ends
    double rough_bin_sigmas = 0.5;                         ///< of the histogram
    double rough_prior = 0.5;                              ///< count of each bin before any point
    double least_rough_points = 200;                       ///< of a rough zone, for the histogram of its radii
    double steepest_rough_wall = 0.1;                      ///< slope of the wall beside it
};

inline constexpr PlaneLimits planeLimits;

/// Stretches between planes (stretches.h).
struct StretchLimits {
    double data_gap_mm = 1.2;           ///< a longer stretch without data is a gap, not an edge
    std::size_t blurred_end_walls = 3;  ///< pieces of no more walls at a chain's end come from blur
    double coverage_share = 0.5;        ///< a chain that lies beside a longer one over more of its length is left out
    double step_errors = 5;             ///< standard errors of a jump between lines that is no chance
    double step_reach_mm = 0.4;         ///< lines that meet no further off have a common corner
    double step_parallel_slope = 1e-9;  ///< lines with a smaller difference of slopes do not meet
    std::size_t least_walls = 3;        ///< of a stretch

    // Rough zones: threads and knurls.
    double shortest_rough_mm = 2.5;
    double rough_ratio = 1.3;                              ///< of a wall's scatter to that from noise and slope
    double rough_errors = 3;                               ///< standard errors of a scatter that are added to the ratio
    double least_scatter_mm = 0.001;                       ///< of a thread or knurl in data without noise
    double assumed_spot_mm2 = 0.0225;                      ///< (0.15 mm)², the spot of the practice scans
    std::size_t most_smooth_walls = 6;                     ///< a rough zone ends before so many without roughness
    std::size_t most_faded_walls = 2;                      ///< within the stretch over which it fades into a cone
    std::size_t walls_beyond = 3;                          ///< that a groove may reach besides
    double longest_lead_mm = 4;                            ///< the cone that leads into a rough zone
    double longest_lead_part = 3;                          ///< the zone is at least so many times as long
    double root_share = 0.02;                              ///< quantile of the radii that is the root
    double circle_reach_mm = 2, circle_reach_share = 0.2;  ///< of the radius: points that may belong to the zone
    double zone_reach_share = 0.5;                         ///< of the radius: points whose median it is
    std::size_t least_circle_points = 30;                  ///< of a circle
    int circle_rounds = 5;                                 ///< of its robust fit
    double circle_outlier_sigmas = 4;
    double circle_regularisation = 1e-9;  ///< of the normal matrix, in its units: points on a line have no circle
    double largest_lobe_mm = 0.1;         ///< amplitude of lobes of form: higher ones are a shape
    double eccentric_ratio = 1.6;         ///< an eccentric round has no more scatter than this multiple of the noise
    double least_eccentricity_mm = 0.05;
};

inline constexpr StretchLimits stretchLimits;

/// From stretches to a fitted outline (outline.h).
struct OutlineLimits {
    double wall_reach_mm = 0.5;    ///< fine walls beyond a stretch that may belong to it
    double wall_step_mm = 0.3;     ///< largest difference of the radius to the nearest coarse wall, for noise
    double wall_slope_factor = 2;  ///< times the slope between them, added to it
    double wall_slope_mm = 0.2;    ///< width of the blur: the slope over it is added as well
    double starting_spot_mm = 0.1;
    double end_sigma_mm = 0.05, shoulder_sigma_mm = 0.1;  ///< of the starting values of planes
    int first_iterations = 6, iterations = 8,
        last_iterations = 25;  ///< of the joint fit at the start, between selections and at the end

    // Rough zones that begin on a cone.
    double cone_reach_mm = 3;               ///< the place where it reaches the crests is no further from the plane
    double least_cone_slope = 0.2;          ///< of a cone that leads into a thread
    double least_cone_variance_mm2 = 1e-6;  ///< (1 µm)²
};

inline constexpr OutlineLimits outlineLimits;

/// Ends that are balls (ball_ends.h). What is lost about the axis: readings within 0.8 mm of the scanner's axis, of a
/// part up to 0.8 mm beside it, and rays that graze the surface at less than 12°.
struct BallLimits {
    double on_ball_sigmas = 4;                 ///< points so far from the ball are on it,
    double on_ball_share = 5e-4;               ///< and this share of its radius further
    std::size_t stray_points = 10;             ///< so many may be nearer to the axis by chance
    double largest_cap_share = 0.35;           ///< of the radius: that of the cap that is not seen is smaller,
    double highest_cap_mm = 0.5;               ///< and its height; walls within it do not count in the fit of the ball
    double lost_radius_mm = 2;                 ///< points are seen within this of the axis, on the ball or not,
    double grazed_share = 0.2;                 ///< or within this share of the ball's radius
    double flat_sigmas = 1.5, flat_mm = 0.01;  ///< scatter along the axis of points on a face in place of the pole
};

inline constexpr BallLimits ballLimits;

/// Worn seats as one row (wear.h).
struct WearLimits {
    double largest_bend_rad = selectionLimits.merged_bend_rad;  ///< a sharper bend is a designed feature
    double level_share = 0.5;    ///< of the form tolerance, for the level on both sides of a score
    std::size_t mean_walls = 5;  ///< means over so many walls are compared with the form tolerance
    double end_margin_mm = 0.1;  ///< walls nearer to the ends of a seat do not count
    double shortest_seat_mm = 1;
    double no_step_um_per_mm = 5e-3;    ///< of a wall's scatter: a smaller jump is rounding
    double slope_half_width_mm = 0.05;  ///< of the difference that gives the slope of a piece
    double least_spread_mm2 = 1e-12;
};

inline constexpr WearLimits wearLimits;

/// Rows of a table (dimensions.h).
struct DimensionLimits {
    /// Error of the diameter per µm of a two-lobed form error (radius) when only this arc (degrees) is seen.
    std::array<std::pair<double, double>, 8> ovality{
        {{60, 5.5}, {90, 5.0}, {120, 4.3}, {180, 2.9}, {210, 2.1}, {270, 1.0}, {300, 0.6}, {360, 0}}};
    double derivative_step = 1e-5;      ///< of each parameter
    std::size_t least_form_walls = 60;  ///< with less the form cannot be separated from noise
    int form_samples = 100;             ///< of the polynomial along the row
    double form_step = 0.02;            ///< between them, from -1 to 1
    double least_taper_walls = 5;       ///< of a row whose taper is stated
};

inline constexpr DimensionLimits dimensionLimits;

}  // namespace lathelier::features
