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
    double rough_sigmas = 4;            // and within so many of a rough wall's own scatter (a thread, a knurl)
    double roughest_mm = 1.2;           // scatter above which a wall is no surface: half the depth of a thread, pitch 6
    double roughest_share = 0.08;       // likewise, as a share of its radius: half the depth of a trapezoidal thread
    double least_coverage = 0.5;        // share of the usual coverage of the circle: the tops of jaws cover less,
    double least_rough_coverage = 0.7;  // and of a rough wall
    double smooth_sigmas = 3;           // scatter of a smooth wall, in standard deviations of the noise: with its slope
    double long_chain_mm = 5;           // a shorter chain is a surface only when it is dense:
    double least_density_share = 0.05;  // points per mm as a share of the usual ones
    double poor_wall_share = 0.25;      // of the usual points of a chain: a wall at its end with fewer is not of it
    double least_rough_mm = 10;         // length of a chain of rough walls that counts as a surface
    double least_rough_share = 0.02;    // of all points that it holds
    double beyond_chain_mm = 1.5;  // a wall may continue so far beyond its chain: its bins beside edges are dropped
    double face_mm = 0.5;          // points so near to the end of a chain, along the axis, may lie on a face there
    double faces_share = 0.05;     // of all points: with more on faces the scan shows these
    double shoulder_mm = 3;        // two chains no further apart have a shoulder between them

    // A loose cluster: a cloud that fills space, not a sheet.
    double fine_cube_mm = 1.5;          // cubes in which the shape of the cloud is judged: of dense clusters,
    double coarse_cube_mm = 4;          // and of thin ones
    std::size_t least_in_cube = 8;      // number of points from which a cube is judged
    double filled_deviation = 0.12;     // least deviation in a cube, as a share of its edge; evenly filled: 0.29
    double cloud_sigmas = 4;            // and in standard deviations of the noise
    std::size_t least_in_cluster = 40;  // number of points: fewer neither form a wall nor a mark
    double cluster_ratio =
        0.3;                    // smallest to largest deviation of a whole cluster, also of half of one above a surface
    double core_share = 0.06;   // of its points within one standard deviation; normal distribution: 0.20
    double filled_share = 0.7;  // of its points in filled cubes
    double wall_behind_share = 0.5;     // of the directions in which a thin cluster is seen: the wall is seen there too
    double crowd_ratio = 1.5;           // a cluster holds so many times the usual points of the wall: these go with it,
    double crowd_sigmas = 3;            // within so many standard deviations
    double cluster_reach_sigmas = 4.5;  // points of a cluster lie this near to its middle

    // A holder: what grips an end of the part.
    double outside_mm = 1;              // points this far outside the surface may be those of a holder
    double holder_reach_mm = 5;         // least height of a jaw above the part (that of a clamp, scene.cpp),
    double holder_reach_share = 0.3;    // and as a share of the part's radius where no chuck is seen: splines are lower
    std::size_t least_in_holder = 100;  // number of points
    int most_jaws = 6;                  // chucks have 2, 3, 4 or 6
    double low_share = 0.35;            // between jaws the height is at most this share of theirs,
    double low_directions = 0.1;        // in at least this share of the directions
    double plane_share = 0.08;          // least share of a holder's points in a plane that counts as one of its faces
    double all_planes_share = 0.3;      // least share in all such planes
    double touching_mm = 2;             // the chuck begins no further behind the ends of the jaws
    double least_part_mm = 5;           // length of the part that must be seen outside the holder
    double beside_holder_mm = 0.3;      // points of the part this near to a holder are left out with it
    double between_jaws_share = 0.25;   // of the usual points: with fewer the part is not seen between the jaws
    double hidden_end_mm = 1.5;         // an end of the data this near to a holder is no end of the part

    // A centre (ISO 866: 60°) in the end of the part.
    double centre_half_angle_deg = 30;
    double centre_angle_error_deg = 1.5;
    double centre_fit_mm = 2;       // length of the cone from which its angle is found
    double centre_tip_share = 0.5;  // its radius at the part is at most this share of the part's
};

inline constexpr SurroundingsLimits surroundingsLimits{};

}  // namespace lathelier::features
