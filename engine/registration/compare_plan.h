// How two parts are to be compared: their axes, and the method that follows.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/registration/compare.h"
#include "engine/registration/revolution/revolution.h"

namespace lathelier::registration {

/// Axis fits of the two parts and the method that follows.
struct ComparePlan {
    CompareMethod method = CompareMethod::Plane;
    TurnedPart reference;
    TurnedPart copy;
    bool reference_turned = false;  ///< the reference is a body of revolution
};

/// Fits axes where needed and chooses the method. Errors: notABodyOfRevolution and
/// coverageTooSmall when the parameters require an axis, pointsDegenerate for a line of noise.
ComparePlan makePlan(const std::vector<Eigen::Vector3d>& reference, const std::vector<Eigen::Vector3d>& copy,
                     const CompareParameters& asked, Notes& notes, const Progress& progress);

}  // namespace lathelier::registration
