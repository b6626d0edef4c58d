// Volume that convex bodies cut out of a turned body: integral over parallel lines across the axis of the length of the
// union of the bodies within the material. The lines lie oblique to the frame, so that faces along it are no rows of
// lines; the error is below 5e-3 of the volume.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"
#include "engine/shaft/shaft.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {

/// The points of a half space: n·p <= distance.
struct HalfSpace {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
    double distance_mm = 0;
};

/// The points about a line whose distance from it is at most radius + slope·t, t the position along it, where that is
/// not negative: a cylinder, or one nappe of a cone.
struct RoundSpace {
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    double radius_mm = 0;
    double slope = 0;
};

/// What all of its parts hold, in the frame of the shaft.
struct ConvexCut {
    std::vector<HalfSpace> half_spaces = {};
    std::vector<RoundSpace> round_spaces = {};
};

/// Radii of the material at a z; 0: none.
struct Ring {
    double outer = 0, inner = 0;
};

/// Of a contour as closedContour() gives it.
Ring ringAt(const Contour& contour, double z_mm);

/// mm³ of the union of the cuts within the material. Throws Cancelled.
double cutVolume_mm3(const std::vector<ConvexCut>& cuts, const Shaft& turned, const Progress& progress);

}  // namespace lathelier::cad
