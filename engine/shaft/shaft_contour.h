// The meridian of a shaft as exact pieces: straight lines and circular arcs in the plane (z, r), z from the free end.
//
// An arc's centre follows from its end points, its radius and its side: with the unit vector n to the left of the
// direction of travel (away from the axis when z grows), centre = middle of the chord - sign(q)·n·√(q² - h²/4), h the
// chord. Volumes are π∮r²dz, exact for lines and arcs:
//   line  π·Δz·(r₀² + r₀r₁ + r₁²)/3
//   arc   π[F(t₁) - F(t₀)], F(t) = -ρ(-r_c² cos t + 2 r_c ρ (t/2 - sin 2t/4) + ρ²(cos³t/3 - cos t)),
// t the angle about the centre from the direction of z.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier {

/// One piece of a meridian. Points are (z, r) in mm.
struct ContourPiece {
    static constexpr std::ptrdiff_t none = -1;

    Eigen::Vector2d from_mm = Eigen::Vector2d::Zero();  ///< start
    Eigen::Vector2d to_mm = Eigen::Vector2d::Zero();    ///< end
    double arc_radius_mm = 0;    ///< 0: a line; > 0 bulges to the left of the direction of travel, < 0 to the right
    std::ptrdiff_t row = none;   ///< of its contour; `none`: a face between rows, or an end face, or the axis
    std::ptrdiff_t bore = none;  ///< which bore it belongs to; `none`: the outside

    bool isArc() const { return arc_radius_mm != 0; }
    /// Of an arc. Precondition: its radius is at least half its chord (a little less counts as half).
    Eigen::Vector2d centre_mm() const;
    /// Angles about the centre of its start and its end, the latter less than half a turn from the former.
    std::pair<double, double> arcAngles() const;
    /// Along the piece, mm.
    double length_mm() const;
    /// Radii of the meridian at this z, for a piece that runs along z without turning back.
    double radiusAt_mm(double z_mm) const;
    /// π∫r²dz along the piece; negative where it runs toward the free end.
    double sweptVolume_mm3() const;
    /// The same piece run backwards.
    ContourPiece reversed() const;
};

using Contour = std::vector<ContourPiece>;

/// The outside from the free end to the chuck: rows and the faces of shoulders between them, pieces of no length left
/// out.
Contour outerContour(const Shaft& shaft);

/// Bore number `bore` from its mouth inward, in the z of the shaft; ends at its last row.
Contour boreContour(const Shaft& shaft, std::size_t bore);

/// Does the bore run through the whole part?
bool isThrough(const Shaft& shaft, const ShaftBore& bore);

/// The closed meridian of the material: from the free end's face outward, along the outside, down the chuck's face and
/// back along bores or the axis (clockwise with z to the right and r upward). Pieces on
/// the axis have row and bore `none` and r = 0. Bores stated by ShaftSegment::bore_diameter_mm are laid in as bores
/// whose steps follow the rows.
Contour closedContour(const Shaft& shaft);

/// Volume of the material without its marks, exact.
double volume_mm3(const Shaft& shaft);

/// Points where two pieces meet, touching ends counted.
std::vector<Eigen::Vector2d> meetingPoints(const ContourPiece& a, const ContourPiece& b);

/// The shaft described by lengths, diameters and ShaftSegment::bore_diameter_mm only: `bores` are merged into the rows,
/// which are cut where the bores step (a bore's cone or arc becomes 20 steps), and a row that runs back, the face of an
/// undercut, is subtracted from the row before it. Marks stay.
Shaft beamView(const Shaft& shaft);

}  // namespace lathelier
