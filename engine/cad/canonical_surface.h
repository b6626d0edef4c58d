// Which plane, cylinder, cone, sphere or revolved arc a free-form surface is exactly: CAD programs also write these as
// splines.
//
// The normals decide: those of a cylinder are coplanar, those of a cone make one angle with its axis, those of a sphere
// meet in its centre, and those of any surface of revolution meet its axis - one linear equation for each in the
// Plücker coordinates of the axis (H. Pottmann, J. Wallner, Computational Line Geometry, 2001, section 3.1).
#pragma once

#include <optional>
#include <span>

#include "engine/cad/step_faces.h"

namespace lathelier::cad {

/// Kind, axis, radius and centre of the meridian circle as StepFace has them; `inner_mm` is that of the face.
struct CanonicalSurface {
    SurfaceKind kind = SurfaceKind::Other;
    Eigen::Vector3d axis_point_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    double radius_mm = 0;
    Eigen::Vector3d circle_centre_mm = Eigen::Vector3d::Zero();
};

/// Largest distance of a point from the surface found.
inline constexpr double canonicalTolerance_mm = 1e-5;

/// Plane, Cylinder, Cone, Sphere or RevolvedArc (a torus among them); none where no one of them has all the points
/// within canonicalTolerance_mm, and for fewer than 12 spots.
std::optional<CanonicalSurface> canonicalSurface(std::span<const SurfaceSpot> spots, const Eigen::Vector3d& inner_mm);

}  // namespace lathelier::cad
