// The plane that a part stands or lies on, and the part's end in it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/features/outline/outline.h"
#include "engine/features/scene/scene.h"

namespace lathelier::features {

/// The turntable among points that cover their surface evenly, no two of them nearer than about `spacing_mm`. None: no
/// plane holds a tenth of the points, has the others on one side of it and is three times as large as the largest group
/// of them.
std::optional<SupportPlane> findSupport(const std::vector<Eigen::Vector3d>& points, double spacing_mm);

/// Moves the end of the outside on the plane into it: the points between were removed with the plane. Does
/// nothing when the axis leans from the normal by more than 1°, or no end is near. True: an end was moved.
bool endOnSupport(const SupportPlane& support, const registration::RevolutionFit& fit, Outline& outline,
                  const Progress& progress = {});

}  // namespace lathelier::features
