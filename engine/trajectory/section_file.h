// Sections of trajectories as tables in CSV: one row for each section, or one for each point of their images.
#pragma once

#include <string>

#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// Columns section, z_mm, revolutions_used, diameter_mm, centre_x_um, centre_y_um, RONt of the four circles, two-point
/// range, run-out, error motion of X3, tolerance and verdict. Decimal point, comma, full precision; missing values are
/// empty. Error fileNotWritable.
void writeSectionTable(const std::string& path, const TrajectoryResult& result);

/// Columns section, z_mm, i, angle_deg, body_angle_deg, radius_mm, x_mm, y_mm, then for each probe its mean, standard
/// deviation and the confidence of the mean in µm. Error fileNotWritable.
void writeImages(const std::string& path, const TrajectoryResult& result);

}  // namespace lathelier::trajectory
