// Limits of the steps of a recognition that belong to no stage (recognition.h, recognition_finish.h).
//
// Where no origin is stated, a value was chosen on the practice scans: synthetic scans of turned parts with known
// truth. Names end in the unit; `…_sigmas` are multiples of the noise of single points.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lathelier::features {

struct RecognitionLimits {
    // Points and bins.
    std::size_t mesh_samples = 400000;  ///< points drawn on a mesh
    int facet_rounds = 2;  ///< the axis of flat facets differs from that of the round surface through their corners
    double bin_mm = 0.1;   ///< for the cutting; those for the fit are half as wide
    double points_per_bin = 25;  ///< bins with fewer are wider
    double bin_sigmas = 2;  ///< least width for scans without rows of rays, whose noise moves points along the axis
    std::int64_t least_points = 50;  ///< stated where no outline is found

    double mostly_turned_share = 0.5;  ///< of the points, about one axis: the others are unexplained structure

    // Bores.
    double end_reach_mm = 1;         ///< a bore that comes so near to an end reaches it
    double same_diameter_mm = 0.05;  ///< cylinders on both sides of a stretch without points are one
    double unseen_mm = 0.05;         ///< a longer distance of rows is a stretch without points

    // Uncertainty of a part of the circle.
    double full_coverage_deg = 300;  ///< with less, ovality is taken for size
    double half_coverage_deg = 180;  ///< with less, another note says so
    double least_ovality_um = 5;     ///< of a turned part, where the scanner's accuracy is finer

    // Rows where noise is correlated or passes differ.
    double unsure_um = 1000;            ///< a size with a larger U is not determined,
    double unsure_angle_deg = 45;       ///< nor the angle of a cone, and then its length is not either
    double unsure_radius_share = 0.05;  ///< nor a radius when it is this share of the radius as well
    double coverage_factor = 2;         ///< of the shared errors that a row has to exceed
    double unproven_jump_u = 2.5;       ///< five standard errors: a lower jump between cylinders may be chance

    double flying_share = 0.05;  ///< of the points: largest number that counts as flying about the part
};

inline constexpr RecognitionLimits recognitionLimits;

}  // namespace lathelier::features
