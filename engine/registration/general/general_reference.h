// A reference of any shape, prepared once: its surface serves the alignment and the deviation after it.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/surface/surface.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::registration {

/// Points relative to their own middle: a distant origin would cost precision.
struct CentredPoints {
    std::vector<Eigen::Vector3d> points_mm;
    Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();  ///< median of each coordinate
    double size_mm = 0;                                   ///< nine tenths of the points are nearer to the middle
};

/// The points of a cloud, or samples of a mesh by area. Errors, with `role`: tooFewPoints (fewer than 4),
/// pointsDegenerate.
CentredPoints centrePoints(const Scan& scan, const char* role, const Progress& progress);

/// Up to `count` of the points, spread evenly over the list.
std::vector<Eigen::Vector3d> everyNth(const std::vector<Eigen::Vector3d>& points_mm, std::size_t count);

struct GeneralReference {
    CentredPoints points;
    std::shared_ptr<Surface> surface;  ///< about points.middle_mm
};

/// Errors: tooFewPoints (fewer than 4), pointsDegenerate (in one place or on a line). Throws Cancelled.
GeneralReference prepareReference(const Scan& reference, const Progress& progress = {});

/// The same of a drawing: `mesh` is that of the meridian, in one frame.
GeneralReference prepareReference(const Scan& mesh, const Contour& meridian, const Progress& progress = {});

}  // namespace lathelier::registration
