// Thresholds by which objects about a part are told from the part. None is a value of a standard: each was chosen on
// made scans of shafts with clusters, chucks, centres, marks, threads, teeth and holes; where a size of a real object
// is behind it, that is said.
#pragma once

#include <cstddef>

namespace lathelier::features {

struct SurroundingsLimits {
    // A point lies on a seen surface within this many standard deviations of the noise, plus a distance in mm: the same
    // band as for a point of a mark (marks.cpp).
    double on_sigmas = 5;
    double on_mm = 0.1;
    double rough_sigmas = 4;       ///< and within so many of a rough wall's own scatter (a thread, a knurl)
    double roughest_mm = 1.2;      ///< scatter above which a wall is no surface: half the depth of a thread, pitch 6
    double roughest_share = 0.08;  ///< likewise, as a share of its radius: half the depth of a trapezoidal thread
    double least_coverage = 0.5;   ///< share of the usual coverage of the circle: the tops of jaws cover less,
    double least_rough_coverage = 0.7;  ///< and of a rough wall
    double smooth_sigmas = 3;  ///< scatter of a smooth wall, in standard deviations of the noise: with its slope
    double long_chain_mm = 5;  ///< a shorter chain is a surface only when it is dense:
    double least_density_share = 0.05;  ///< points per mm as a share of the usual ones
    double poor_wall_share = 0.25;      ///< of the usual points of a chain: a wall at its end with fewer is not of it
    double least_rough_mm = 10;         ///< length of a chain of rough walls that counts as a surface
    double least_rough_share = 0.02;    ///< of all points that it holds
    double beyond_chain_mm = 1.5;  ///< a wall may continue so far beyond its chain: its bins beside edges are dropped
    double face_mm = 0.5;          ///< points so near to the end of a chain, along the axis, may lie on a face there
    double faces_share = 0.05;     ///< of all points: with more on faces the scan shows these
    double shoulder_mm = 3;        ///< two chains no further apart have a shoulder between them

    double surface_step_mm = 0.25;            ///< along the axis, of the tabulated surface
    std::size_t most_surface_bins = 4000000;  ///< longer data are not divided
    std::size_t slope_walls = 2;              ///< walls to both sides that show the slope
    double steepest_slope = 2;                ///< of a wall that can be told from a face
    double cell_turns = 72;                   ///< cells of a wall: 5° about the axis by 1 mm along it
    double zone_reach_mm = 0.5;               ///< the data reach up to a zone, less one bin
    std::size_t least_walls = 3;              ///< of a chain
    int most_searches = 4;                    ///< of surroundings: each may uncover others
    int most_placings = 2;                    ///< of the axis after points were left out

    // A loose cluster: a cloud that fills space, not a sheet.
    double fine_cube_mm = 1.5;          ///< cubes in which the shape of the cloud is judged: of dense clusters,
    double coarse_cube_mm = 4;          ///< and of thin ones
    std::size_t least_in_cube = 8;      ///< number of points from which a cube is judged
    double filled_deviation = 0.12;     ///< least deviation in a cube, as a share of its edge; evenly filled: 0.29
    double cloud_sigmas = 4;            ///< and in standard deviations of the noise
    std::size_t least_in_cluster = 40;  ///< number of points: fewer neither form a wall nor a mark
    double cluster_ratio =
        0.3;  ///< smallest to largest deviation of a whole cluster, also of half of one above a surface
    double core_share = 0.06;        ///< of its points within one standard deviation; normal distribution: 0.20
    double filled_share = 0.7;       ///< of its points in filled cubes
    double wall_behind_share = 0.5;  ///< of the directions in which a thin cluster is seen: the wall is seen there too
    double crowd_ratio = 1.5;        ///< a cluster holds so many times the usual points of the wall: these go with it,
    double crowd_sigmas = 3;         ///< within so many standard deviations
    double cluster_reach_sigmas = 4.5;  ///< points of a cluster lie this near to its middle

    int fit_rounds = 6;     ///< of the fit of a cluster's middle and extent
    double fit_sigmas = 3;  ///< points further from the middle do not take part in it
    int most_seeds = 8;     ///< places in a group at which a fit begins
    int fit_rings = 2;      ///< cubes beside those of a cluster in which its other points are sought

    // A holder: what grips an end of the part.
    double outside_mm = 1;            ///< points this far outside the surface may be those of a holder
    double holder_reach_mm = 5;       ///< least height of a jaw above the part (that of a clamp, scene.cpp),
    double holder_reach_share = 0.3;  ///< and as a share of the part's radius where no chuck is seen: splines are lower
    std::size_t least_in_holder = 100;  ///< number of points
    int most_jaws = 6;                  ///< chucks have 2, 3, 4 or 6
    double low_share = 0.35;            ///< between jaws the height is at most this share of theirs,
    double low_directions = 0.1;        ///< in at least this share of the directions
    double plane_share = 0.08;          ///< least share of a holder's points in a plane that counts as one of its faces
    double all_planes_share = 0.3;      ///< least share in all such planes
    double touching_mm = 2;             ///< the chuck begins no further behind the ends of the jaws
    double least_part_mm = 5;           ///< length of the part that must be seen outside the holder
    double beside_holder_mm = 0.3;      ///< points of the part this near to a holder are left out with it
    double between_jaws_share = 0.25;   ///< of the usual points: with fewer the part is not seen between the jaws
    double hidden_end_mm = 1.5;         ///< an end of the data this near to a holder is no end of the part
    double jaw_cube_mm = 4;             ///< neighbours on a jaw lie in neighbouring cubes
    double jaw_cube_spacings = 4;       ///< likewise in thin scans, in distances of points
    double look_mm = 0.25;              ///< step along the axis
    double before_jaws_mm = 25;         ///< the part is seen within this distance before the jaws
    double end_quantile = 0.005;        ///< of a group's z: where it begins
    double jaw_contact_mm = 2.5;        ///< points of a jaw this near to the part mark the contact (scene.cpp)
    double between_jaws_mm = 5;         ///< length behind the fronts of the jaws in which the part is sought
    std::size_t jaw_directions = 72;    ///< about the axis
    double face_centre_share = 0.6;     ///< of the part's radius at the face: points there belong to the centre
    double largest_quantile = 0.99;     ///< of the radii of a group: its largest
    std::size_t most_plane_points = 1500;  ///< of a group: more are thinned
    int most_planes = 8;                   ///< of a group
    int plane_directions = 360;            ///< of half a turn
    double most_plane_bins = 1e5;          ///< bounds the memory
    double least_slab_mm = 0.25;           ///< thickness of a plane: noise, and half a step of the direction over 50 mm

    // A centre (ISO 866: 60°) in the end of the part.
    double centre_half_angle_deg = 30;
    double centre_angle_error_deg = 1.5;
    double centre_fit_mm = 2;       ///< length of the cone from which its angle is found
    double centre_tip_share = 0.5;  ///< its radius at the part is at most this share of the part's
};

inline constexpr SurroundingsLimits surroundingsLimits{};

}  // namespace lathelier::features
