// Curves over the axis made of lines and arcs, x = f(u): upper envelopes, and the distance of points from them.
// u in mm from the free end toward the chuck, x the radius in mm; in a curve vertical pieces join what jumps.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace lathelier::cam {

/// The contact between tool and part that generates a piece of a curve.
enum class Touch : std::uint8_t {
    Element,   ///< the nose touches a line or an arc of the contour
    Vertex,    ///< the nose touches a corner of the contour
    BackRay,   ///< the back edge touches a point behind the nose
    LeadRay,   ///< the main edge touches a point ahead of the nose
    Bridge,    ///< the straight edge of a blade touches a local maximum
    Join,      ///< vertical piece at a jump
    Tailstock  ///< insert or holder is limited by the tailstock
};

/// A line, or an arc that is a function of u, from smaller to larger u (a Join stays at one u).
struct CurvePiece {
    Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< where it begins (u, x)
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    double radius_mm = 0;                              ///< 0: a line; > 0 the upper, < 0 the lower half of its circle
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of the circle
    Touch touch = Touch::Element;                      ///< contact that generates it
    std::int32_t source = -1;                          ///< piece of the contour, or the corner before that piece

    bool isArc() const { return radius_mm != 0; }
    double at(double u_mm) const;
    double length_mm() const;
    /// Point at parameter `share` (0 … 1) along the piece; proportional to the angle on arcs.
    Eigen::Vector2d point(double share) const;
    double distanceTo(const Eigen::Vector2d& point) const;
};

using Curve = std::vector<CurvePiece>;

/// The highest of all pieces at each u, merged and joined. Breaks are ends and crossings (closed forms); those nearer
/// than 1e-9 mm are one. Precondition: the pieces cover the interval without gaps. O(n log n + crossings).
Curve upperEnvelope(Curve pieces);

/// Height of a curve; at a jump the higher side. Outside, that of its end. Precondition: not empty.
double heightAt(const Curve& curve, double u_mm);

/// The part within [from, to], joints at its ends included.
Curve clipped(const Curve& curve, double from_mm, double to_mm);
Curve shifted(Curve curve, const Eigen::Vector2d& by);
/// u becomes length - u.
Curve mirrored(const Curve& curve, double length_mm);

/// Shortest distance of a point from the curve. `guess_mm`: search radius; the result is larger if no piece lies
/// within.
double distanceTo(const Curve& curve, const Eigen::Vector2d& point, double guess_mm);

/// Where f(u) < level: maximal intervals within the curve, ascending. Jumps count with both sides.
struct Stretch {
    double from_mm = 0, to_mm = 0;  ///< in u
};
std::vector<Stretch> stretchesBelow(const Curve& curve, double level_mm);

/// Smallest and largest height.
double lowestOf(const Curve& curve);
double highestOf(std::span<const CurvePiece> curve);

}  // namespace lathelier::cam
