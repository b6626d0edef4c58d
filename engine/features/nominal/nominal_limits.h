// Limits of the stages that give rows their roles and nominal sizes. Tables of standards are in standards.h.
//
// Where no origin is stated, a value was chosen on the practice scans: synthetic scans of turned parts with known
// truth.
#pragma once

#include <cstddef>
#include <string_view>

namespace lathelier::features {

/// Joints of rows, undercuts and grooves (row_chain.h).
struct RowPatternLimits {
    double same_diameter_mm = 1e-4;  ///< rows with a smaller step are joined
    double join_gap_mm = 1e-3;       ///< rows further apart have a gap between them
    double least_relief_mm = 1e-6;   ///< rows that overlap by more relieve a face
    double through_mm = 0.1;         ///< a bore that ends no further from the other end is a through bore
    double rough_seam_mm = 0.1;      ///< larger steps of the radius beside a thread or a knurl are shoulders

    // Undercuts.
    double run_out_tolerance_deg = 2;                           ///< of the 15° of DIN 509, besides U
    double deepest_undercut_mm = 1.5, widest_undercut_mm = 10;  ///< above the largest sizes of DIN 509
    double beyond_face_mm = 0.05;  ///< half of the least t2 of form F: a circle that reaches further is of form F

    // Grooves.
    std::size_t most_groove_rows = 5;  ///< of a groove
    double narrowest_groove_mm = 0.2, widest_groove_mm = 8;
    double widest_groove_share = 0.5;  ///< of the diameter beside it
    double shallowest_groove_mm = 0.1, least_flank_deg = 10;
    double same_end_mm = 0.002;  ///< of diameters: ends of neighbouring rows that are one
};

inline constexpr RowPatternLimits rowPatternLimits;

/// Roles of rows (roles.h).
struct RoleLimits {
    double shallowest_chamfer_deg = 10, steepest_chamfer_deg = 80;
    double largest_leg_mm = 6;              ///< above the longest chamfer of the series, 5 mm; longer cones are tapers
    double largest_round_mm = 10;           ///< larger radii are contours, not rounded edges
    double no_diameter_mm = 0.01;           ///< smaller ends are points on the axis
    double arc_end_share = 0.05;            ///< of an arc's length: a lowest point nearer to its ends is at the end
    double covered_share = 0.5;             ///< of a row: a mark that covers more gives it its role
    double smallest_shaped_edge_mm = 0.45;  ///< of smaller edge breaks chamfer and round cannot be told apart
    double uncertain_leg_mm = 0.1;          ///< of such an edge break
};

inline constexpr RoleLimits roleLimits;

/// Nominal sizes (nominal.h, suggestions.h).
struct NominalLimits {
    double rounding_mm = 1e-9;  ///< a size on the border of its window is within
    double grid_share = 20;     ///< windows are at most the grid over this; with 10, 3.2 % instead of 1.9 % of 8000
                                ///< simulated diameters were assigned wrongly
    int diameter_grade = 10;    ///< half its tolerance is the window of a diameter
    double largest_iso_size_mm = 500;       ///< ISO 286-1 has further ranges above
    double least_coverage_deg = 180;        ///< of the circle: with less nothing is suggested
    double chamfer_angle_deg = 1;           ///< window of an angle besides its U
    double chamfer_leg_mm = 0.1;            ///< window of a leg besides its U
    double radius_share = 0.05;             ///< window of a radius: at least this share of it
    double taper_angle_deg = 0.005;         ///< window of a taper besides U: AT8 of ISO 1947
    double steepest_taper_deg = 10;         ///< half angle; steeper cones have angles of chamfers
    double chamfer_angle_spacing_deg = 15;  ///< usual distance of those angles
    double smallest_morse_ratio = 0.7, largest_morse_ratio = 1.04;  ///< of a diameter to the gauge diameter
    std::size_t most_tapers = 3;                                    ///< suggested for a cone
    double pitch_share = 0.01;                                      ///< window of a thread's pitch
    const char* circlip_shaft_lower = "h11";                        ///< DIN 471: rings are made for shafts h11…
    const char* circlip_shaft_upper = "p6";                         ///< …and pass over the seats of bearings
    double circlip_width_mm = 0.14;                                 ///< H13 up to 3 mm
    double undercut_depth_mm = 0.1, undercut_width_mm = 0.2, undercut_radius_mm = 0.1;  ///< tolerances of DIN 509
    double unusual_shaft_price = 0.25;  ///< in shares of these tolerances: decides between equally near undercuts
    std::size_t most_fits = 3;          ///< ISO 286-1 classes of one size
    double fit_rounding_um = 1e-6;      ///< a size on the limit of its zone is within
};

inline constexpr NominalLimits nominalLimits;

/// Closed contour of nominal sizes (nominal_chain.h, snap.h).
struct PlacingLimits {
    double tangent_deg = 0.2;     ///< an arc with a smaller corner to its neighbour is tangent to it
    double on_axis_mm = 0.005;    ///< radius of an arc's end on the axis
    double straight_sine = 1e-6;  ///< of the corner between two neighbours: with less they are one line
    double rounding_mm = 1e-9;    ///< a length that moves by no more is as measured
};

inline constexpr PlacingLimits placingLimits;

}  // namespace lathelier::features
