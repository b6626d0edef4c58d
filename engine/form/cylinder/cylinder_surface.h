// Points of a cylindrical surface about the axis of a fitted cylinder: deviations, the unrolled surface, the local
// radius and the local centre along the axis.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/skin.h"
#include "engine/form/cylinder/cylindricity.h"

namespace lathelier::form {

struct CylinderSurface {
    FittedCylinder cylinder;  ///< reference of the deviations: distance from its axis minus its radius
    /// Transforms points into the cylinder's frame: z along the axis, 0 at the first data; angle 0 along x.
    Eigen::Isometry3d axis_T_points = Eigen::Isometry3d::Identity();
    std::vector<float> deviation_mm;  ///< one for each point; 0 for one that was left out

    // Mean deviation on a z × angle grid, row-major, z slow; NaN where there are no points.
    double z_start_mm = 0;  ///< lower edge of the first row
    double z_step_mm = 1;   ///< height of a row
    int z_count = 0;
    int angle_count = 0;         ///< over 360°, cell centres at (j + ½)·360/angle_count
    std::vector<float> mean_um;  ///< of the deviations in each cell

    // By row.
    std::vector<double> z_mm;         ///< centre of the row
    std::vector<double> mean_row_um;  ///< mean over the angles; NaN without data
    std::vector<double> lowest_um;    ///< smallest deviation of a point
    std::vector<double> highest_um;   ///< largest deviation of a point
    std::vector<double> centre_x_um;  ///< of the row's least-squares circle, from the axis; NaN where less than half
    std::vector<double> centre_y_um;  ///< of the angles have data
};

/// `sections`: planes across the axis that the points lie in (CylindricityResult::sections), each of which becomes a
/// row; 0: none. The same bits for any number of threads. Throws Cancelled.
CylinderSurface surfaceAbout(const FittedCylinder& cylinder, std::span<const Eigen::Vector3d> points_mm,
                             std::size_t sections, const Progress& progress = {});

/// The closed surface in the cylinder's frame, its ends discs. Values: deviations in mm; NaN where there are no points.
Skin skinOf(const CylinderSurface& surface);

/// The point of the cylinder at this z and angle, in the coordinates of the points.
Eigen::Vector3d placeOnCylinder(const CylinderSurface& surface, double z_mm, double angle_deg);

/// z along the axis from the first data, and the angle about it, 0…360, of a point.
Eigen::Vector2d placeAbout(const CylinderSurface& surface, const Eigen::Vector3d& point_mm);

}  // namespace lathelier::form
