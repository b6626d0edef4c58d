// Limits of what is named a hole; chosen on synthetic scans with known truth where no origin is stated.
#pragma once

#include <cstddef>

namespace lathelier::features {

struct HoleLimits {
    // Where a rim is sought.
    std::size_t least_cells = 2;      ///< of a region without the wall
    std::size_t most_regions = 100;   ///< more are gaps of teeth or a scan with patches: bounds the time
    double least_area_mm2 = 2;        ///< of cells without the wall
    double most_aspect = 2.6;         ///< of their box: the cells are coarse, the rim judges
    double beside_mm = 3.5;           ///< of the hole, on all sides of a window
    double most_radius_share = 0.85;  ///< of the wall's radius
    double most_half_rad = 1.35;      ///< of a window about the axis
    // What a rim must show.
    double least_diameter_mm = 3;                ///< below that scanners lose points at random
    double least_rays = 25;                      ///< that a hole of its size takes from the wall
    double most_wall_inside = 0.06;              ///< share of the wall's points inside
    double clear_mm = 0.1, clear_blurs = 3;      ///< from the rim: nearer points are on either side
    double ring_mm = 0.9;                        ///< width of the ring outside where the wall must be seen
    std::size_t sectors = 12;                    ///< of that ring
    double least_open_share = 0.5;               ///< of a sector within the wall or face: others are not judged
    std::size_t least_judged = 8;                ///< sectors
    std::size_t most_hidden = 1;                 ///< sectors whose wall is not seen
    double least_ring_share = 0.5;               ///< of the wall's points in a sector that is seen
    double least_ring_rays = 3;                  ///< expected in a sector
    std::size_t rim_sectors = 8;                 ///< whose own distance from the centre is compared
    double rim_open_share = 0.95;                ///< of such a sector within the wall or face
    std::size_t least_rims = 5;                  ///< such sectors
    double rim_reach_mm = 0.7;                   ///< of the points that place the rim of a sector
    double rim_rms_mm = 0.17, rim_share = 0.01;  ///< rms of these distances, and of the diameter
    double spacings = 0.35;                      ///< of the points' spacing, in that rms besides
    // What lies inside.
    std::size_t least_floor_points = 8;  ///< fewer say nothing of a floor
    double least_depth_mm = 0.6;         ///< near the rim: less is a dent
    double least_wall_share = 0.4;       ///< of the depth that lies between the rim and the outer part of the floor
    double outer_share = 0.5, floor_share = 0.85;  ///< of the radius: outer part of a floor; all of it
    double floor_scatter_mm = 0.25;                ///< rms of points about a floor
    double least_tip_slope = 0.2;                  ///< of a floor that is the point of a drill; 118° have 0.6
    std::size_t most_lone = 3;                     ///< unequal holes without a second rim or a floor: more are patches
    double slot_length = 1.4;  ///< times its diameter: longer keyways at its place are no floors of a hole
    double same_deg = 15;      ///< between the directions of a hole and a keyway at one place
    // Two rims of one hole.
    double pair_mm = 0.35;        ///< difference of place and diameter
    double pair_sigmas = 4;       ///< besides
    double opposite_share = 0.8;  ///< of the wall seen opposite a hole that ends inside
    double form_mm = 0.08;        ///< standard uncertainty of a diameter beside that of the rays: edges are not sharp
    // Bolt circles.
    std::size_t least_bolts = 3, most_bolts = 12;
    double circle_mm = 0.15;   ///< of places on the circle, radially and along it; and of diameters
    double circle_sigmas = 4;  ///< besides
};

inline constexpr HoleLimits holeLimits{};

}  // namespace lathelier::features
