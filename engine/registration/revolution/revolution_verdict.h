// Test whether a fit is a body of revolution.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

/// Tests the fit: nearly all points on one profile, sufficient points on its side and around it, a single axis, no
/// bend, and a scatter consistent with noise. Fills `coverage_deg` and returns the first reason against a body of
/// revolution. `noise_mm` as in AxisCandidates.
NotTurned judgeRevolution(RevolutionFit& fit, const std::vector<Eigen::Vector3d>& sample, double noise_mm);

}  // namespace lathelier::registration
