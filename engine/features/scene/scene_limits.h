// Limits of the search for objects besides the part.
//
// Where no origin is stated, a value was chosen on synthetic scans of parts on a turntable, with and without clamps.
#pragma once

#include <cstddef>

namespace lathelier::features {

struct SceneLimits {
    // Numbers of points that are looked at; bound the time.
    std::size_t support_sample = 100000, fit_sample = 60000, outline_sample = 300000,
                extent_sample = 20000;  ///< points drawn for the plane, its fit, the outline and the extent
    double extent_low_share = 0.01, extent_high_share = 0.99;  ///< quantiles whose distance is the extent of the scan

    // The plane of a turntable.
    double support_cubes = 128;  ///< over the extent, one point of each is looked at
    double plane_tolerance_mm = 0.5;
    int plane_iterations = 500;          ///< of random samples
    double plane_confidence = 0.999;     ///< probability that one of these holds points of the plane only
    int plane_fit_rounds = 3;            ///< of its robust fit
    double least_plane_share = 0.1;      ///< of the points
    double largest_share_behind = 0.05;  ///< of the points off the plane: the others lie on one side of it
    double least_area_ratio = 3;         ///< of the plane to what stands on it
    std::size_t least_area_points = 3;   ///< of a group whose area counts
    double support_band_sigmas = 4, least_support_band_mm = 0.1;  ///< points so near belong to the plane

    // Groups of points.
    double least_cube_mm = 0.5;
    double group_cubes = 250;                                   ///< over the extent
    double cube_growth = 1.5;                                   ///< cubes grow until they hold four points each
    std::size_t points_per_cube = 4, least_cubes = 200;         ///< mean, and least number of cubes
    double group_gap_cubes = 3;                                 ///< a larger gap separates groups
    std::size_t least_group_cubes = 20, least_clamp_cubes = 5;  ///< of a group, and of a clamp
    std::size_t most_named_groups = 12;                         ///< smaller ones are joined into one

    // The part among the groups.
    std::size_t least_part_points = 500;    ///< of a part
    std::size_t most_part_candidates = 6;   ///< that are tried, the largest first
    std::size_t least_candidate_part = 33;  ///< of the largest group: one in so many
    int axis_rounds = 3;                    ///< of the fit of the axis without outliers
    double surface_margin_mm = 0.7;         ///< points further out are outside the part's surface
    double own_point_share = 0.6;           ///< of a group's points on or inside the surface: it belongs to the part

    // Clamps.
    double clamp_reach_mm = 5;        ///< least height above the surface
    double contact_margin_mm = 2.5;   ///< points of a clamp this near to the surface mark the contact
    double contact_depth_mm = 1.5;    ///< of the surface below its outline
    std::size_t filled_sectors = 12;  ///< of 5°: largest gap of a contact that is filled

    // Outline of the surface of revolution.
    std::size_t least_outline_points = 50;        ///< of an outline
    double least_seen_share = 0.6;                ///< of the directions from which the part is seen
    double points_per_step = 300;                 ///< of an outline
    double least_step_mm = 1, most_steps = 4000;  ///< along the axis
    double least_ring_mm = 0.5;
    std::size_t most_cells = 4000000;  ///< bounds the memory
    std::size_t outer_ring_part = 20;  ///< a ring seen from more than this part of the directions counts

    // The part's end on the turntable.
    double largest_lean_deg = 1;       ///< of the axis from the plane's normal
    double end_reach_mm = 1;           ///< the end lies no further from the plane, besides the band
    double least_end_sigma_mm = 0.01;  ///< flatness of the plane
    double end_sigma_ratio = 4;        ///< the plane is fitted to thousands of points
    int end_fit_iterations = 25;       ///< of the fit of an end on its support
};

inline constexpr SceneLimits sceneLimits;

}  // namespace lathelier::features
