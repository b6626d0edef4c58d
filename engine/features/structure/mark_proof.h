// Proofs that the points of a region must give before it is named: a plane floor, the chord of a flat, grooves that
// explain the scatter. What has none stays unexplained.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace lathelier::features {

/// Thresholds of the proofs.
struct ProofThresholds {
    double slice_mm = 1;           ///< width of the slices along z and across
    double least_slices = 3;       ///< judged: fewer do not tell a plane from the bottom of a pit
    double least_length_mm = 4;    ///< along z: shorter are pits that look plane; the shortest key of DIN 6885 has 6 mm
    double slice_points = 8;       ///< of a slice that is judged
    double slice_sigmas = 4;       ///< by which the mean of a slice may be off
    double slice_mm_off = 0.01;    ///< besides: waviness of a milled floor
    double most_slices_off = 0.2;  ///< share: the walls of the ends fall into some
    double bend_sigmas = 5;        ///< by which a floor may be bent, over half its length: the bottom of a pit is
    double bend_mm = 0.015;        ///< besides: waviness of a milled floor
    double chord_share = 0.15;     ///< by which the width of a flat may differ from its chord
    double chord_mm = 0.6;         ///< besides: two sectors of a shaft of 30 mm
    double keyway_share = 0.75;    ///< of the chord at its floor: a wider floor has no walls
    std::size_t most_alike = 4;    ///< keyways over one stretch; more are the gaps of teeth
    double least_explained = 0.3;  ///< share of the variance beyond noise that the grooves of a thread or knurl explain
    double most_knurl_pitch_mm = 2.2;  ///< DIN 82: 1.6, with room for odd tools; coarser teeth are a serration
};
inline constexpr ProofThresholds proofThresholds{};

/// A point of a floor: place along z and across, distance from the plane.
struct FloorPoint {
    double z_mm = 0, across_mm = 0, off_mm = 0;
};

/// Do the means of slices along z and across lie in the plane, and is it not bent in either direction?
bool isPlane(const std::vector<FloorPoint>& points, double sigma_mm);

enum class FloorShape { Flat, Keyway, Neither };

/// `width_mm`: of the floor between points that lie `limit_mm` below the shaft's radius or deeper.
FloorShape floorShape(double radius_mm, double floor_mm, double width_mm, double limit_mm);

}  // namespace lathelier::features
