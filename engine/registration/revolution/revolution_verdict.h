// Is it a body of revolution?
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

/// Judges the fit: nearly all points on one profile, enough of them at its side and around it, one axis, not bent, and
/// a scatter that looks like noise. Fills `coverage_deg` and gives the first reason against. `noise_mm` as in
/// AxisCandidates.
NotTurned judgeRevolution(RevolutionFit& fit, const std::vector<Eigen::Vector3d>& sample, double noise_mm);

}  // namespace lathelier::registration
