// Limits of the stages that fit a model to the walls and select its elements.
//
// Where no origin is stated, a value was chosen on the practice scans: synthetic scans of turned parts with known
// truth. Names end in the unit; `…_sigmas` are multiples of the noise of single points.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

namespace lathelier::features {

/// The model and its least squares (model.h, model_fit.h).
struct FitLimits {
    // Junctions. Penalties are squares of lengths over `penalty_mm`, so that every starting value has a finite misfit.
    double penalty_mm = 2e-3;
    double no_junction_penalty = 1e6;  ///< where nothing measures how far two elements are from meeting
    double parallel_slope = 1e-9;      ///< lines with a smaller difference of slopes do not meet
    double coincident_mm = 1e-12;      ///< arcs with centres no further apart do not meet
    double arc_overrun_mm = 1e-9;      ///< rounding of a node beyond the half turn of its arc
    double least_element_mm = 0.01;
    double least_depth_share = 1e-6;  ///< of ρ²: bounds the slope of an arc at its half turn

    // Walls.
    double wall_floor_mm = 2e-4;       ///< standard uncertainty of a wall's radius besides its noise
    double least_scatter_share = 0.8;  ///< of the noise of single points: lower bound of a wall's own scatter
    double clear_margin_mm = 0.01, clear_margin_sigmas = 3;  ///< beside a clear shoulder, in σ of its place
    double sharp_corner_rad = 0.3;  ///< walls of surface scans beside a sharper corner do not count
    double steepest_slope = 2;      ///< beyond it the expansion of the noise along the normal does not hold
    double short_arc_sigmas = 4;    ///< shorter arcs are not displaced by noise, those of twice this fully

    // Least squares.
    double huber_sigmas = 4;
    double place_step_mm = 1e-5, slope_step = 1e-6;  ///< of the numeric derivatives; also of ln ρ
    double derivative_reach_mm = 1;  ///< walls beyond the second node on each side may move by this blur
    double damping_growth = 8, damping_fall = 64,
           least_damping = 1e-9;                       ///< of the damping after a step that failed and one that did not
    double regularization = 1e-12;                     ///< added to the diagonal of the normal equations
    double covariance_regularization = 1e-9;           ///< share of the diagonal added before inversion
    double window_damping = 1e-3, window_gain = 1e-3;  ///< starting value; gain of χ² that ends the iterations
    int window_tries = 6;                              ///< of a damped step within a window
    double joint_damping = 1e-4, joint_gain = 1e-4;    ///< at the start, and least relative gain of a step
    int joint_tries = 8;                               ///< of a damped step of all parameters
};

inline constexpr FitLimits fitLimits;

/// Kinds of the elements, inserted and dropped ones (selection.h, selection_criterion.h).
struct SelectionLimits {
    // Criterion.
    double parameter_price = 2.5;  ///< times ln n; Schwarz's criterion has 1: a wider margin against false elements
    double plane_tie_discount =
        6;  ///< saved by an arc's tie to a plane, behind which it may continue unseen, in place of a parameter's price
    double least_gain = 8;             ///< of a new element or an undercut beyond its price
    double kind_gain = 0.5;            ///< of another kind, to avoid alternating between equals
    double unusual_cone_price = 12;    ///< a slope that rises into the foot of a shoulder is more often a fillet
    double unusual_cone_slope = 0.17;  ///< about 10°
    double longest_unusual_cone_mm = 1.5;
    double largest_violation = 1;  ///< of the junctions' penalties, for an accepted change

    // Elements that are free while one is tested.
    double short_neighbour_mm = 5;
    double neighbour_margin_mm = 1.5;  ///< length of longer neighbours over which the misfit is summed
    double drop_reach_mm = 4;          ///< the same where an element is dropped
    double insert_reach_mm = 3;        ///< the same where one is inserted
    int start_iterations = 8, kind_iterations = 10, insert_iterations = 12,
        merge_iterations = 8;   ///< of the fit of a start, a kind, an inserted and a merged element
    int before_iterations = 6;  ///< of the fit that an insertion, a drop or a merge is compared with

    // Pieces as elements.
    double significant_errors = 4;  ///< standard errors of its slope: a line with less is a cylinder
    double longest_doubtful_cone_mm = 4;
    double small_arc_chords = 0.75;   ///< starting radii over the chord
    double large_arc_chords = 2;      ///< radius of a further start, in chords
    double least_chord_ratio = 0.51;  ///< of an arc's radius to its chord: less than half a turn
    double least_radius_mm = 1e-3;

    // Insertion at corners.
    double least_bend_rad = 0.15;
    double small_fillet_mm = 0.3, large_fillet_mm = 1;  ///< starting radii between lines
    double small_round_mm = 0.4, large_round_mm = 1;    ///< starting radii at planes
    double corner_half_chord_mm = 0.1;
    double steepest_wall_slope = 0.5;  ///< an element that meets a plane more steeply gets no fillet or chamfer
    double chamfer_mm = 0.4;           ///< starting leg
    double start_half_share = 0.3;     ///< of an arc's radius or of 0.5 mm: starting nodes on both sides
    double start_line_mm = 0.5;

    // Simplification.
    double short_element_mm = 0.45;         ///< shorter ones are dropped when the misfit grows by less than their price
    double short_surface_element_mm = 0.7;  ///< the same in surface scans, whose edges are not seen
    double drop_gain = 10;                  ///< growth of the misfit beyond the saved price
    double drop_gain_below_spot = 60;       ///< more for elements shorter than the spot
    double merged_bend_rad = 3.4 * std::numbers::pi / 180;
};

inline constexpr SelectionLimits selectionLimits;

/// Undercuts at the feet of shoulders (undercut_search.h).
struct UndercutLimits {
    double run_out_deg = 15;                           ///< DIN 509
    double longest_mm = 8;                             ///< longest of DIN 509: 7 mm, and its run-out
    double shallowest_mm = 0.05;                       ///< smallest t1 of DIN 509 is 0.1 mm
    std::size_t most_replaced_rows = 3;                ///< that one undercut replaces
    double largest_shaft_slope = 0.1;                  ///< of the row before it
    double length_share = 0.95;                        ///< run-out and radius take less of the length
    std::array<double, 4> radii_mm{0.3, 0.6, 1, 1.6};  ///< starting values, about those of DIN 509
    int before_iterations = 8, iterations = 20;        ///< of the fit without and with an undercut
};

inline constexpr UndercutLimits undercutLimits;

}  // namespace lathelier::features
