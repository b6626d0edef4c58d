// The meridian of a body of revolution from the faces of a solid: pieces about an axis, merged and chained.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/cad/step_faces.h"
#include "engine/shaft/shaft.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {

struct Line3 {
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();    ///< on the axis
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector

    /// (z, r) of a point.
    Eigen::Vector2d meridianOf(const Eigen::Vector3d& point) const;
};

/// The common axis of the largest curved area (to 1e-6 rad and 1e-4 mm), pointing to the side of its largest
/// coordinate; spheres are used only if no other face is curved. None: no curved face has an axis.
std::optional<Line3> commonAxis(const std::vector<StepFace>& faces);

struct Meridian {
    Contour closed;                        ///< clockwise in (z, r), without the axis; empty: no piece
    std::vector<std::size_t> other_faces;  ///< faces that are not part of it
    Contour gaps;                          ///< pieces of `closed` that no face shows
};

/// Pieces of the coaxial faces, chained: the smallest turned body around the solid. Of faces that cuts interrupt those
/// that bound the cuts only are left out (meridian_pieces.h). Where faces are missing a straight line closes the gap.
Meridian meridianOf(const std::vector<StepFace>& faces, const Line3& axis, const Progress& progress);

}  // namespace lathelier::cad
