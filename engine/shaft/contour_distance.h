// Signed distance of points from a closed meridian of lines and circular arcs, exact.
//
// To a line: the foot of the perpendicular, else the nearer end. To an arc: |ρ_p - ρ| where the ray from its centre
// meets it, else the nearer end. Sign: the side of the nearest piece; at a corner that of the sum of the unit normals
// of its two pieces (Bærentzen & Aanæs, "Signed distance computation using the angle weighted pseudonormal", 2005; in
// the plane the weights are equal).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/shaft/shaft_contour.h"

namespace lathelier {

class ContourDistance {
public:
    struct Foot {
        double distance_mm = 0;                             ///< + outside the material
        Eigen::Vector2d outward = Eigen::Vector2d::Zero();  ///< unit vector (z, r) along which it is measured
    };

    /// `contour` as closedContour() gives it; its pieces on the axis are no surface. Points further away than
    /// `reach_mm` have no foot.
    ContourDistance(const Contour& contour, double reach_mm);

    /// Of a point at this z and distance from the axis.
    std::optional<Foot> footOf(double z_mm, double r_mm) const;

private:
    struct Piece {
        Eigen::Vector2d from, to, along;  ///< `along`: unit vector of the chord
        Eigen::Vector2d from_normal, to_normal,
            middle;  ///< normals with the neighbour's added; middle of an arc's angle
        Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of an arc
        double length = 0, radius = 0;                     ///< of the chord; of the arc, 0: a line
        double least_cosine = 1;                           ///< of half the arc's angle
        bool bulges_out = false;                           ///< the material lies on the centre's side
        Eigen::Vector2d low, high;                         ///< its box
    };
    void look(const Piece& piece, const Eigen::Vector2d& point, double& nearest, Foot& foot) const;

    std::vector<Piece> pieces_;
    double reach_mm_ = 0, first_mm_ = 0, step_mm_ = 1;
    std::vector<std::uint32_t> start_, within_;  ///< pieces within reach of each step along z
};

}  // namespace lathelier
