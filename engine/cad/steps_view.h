// The shaft as the table of steps that the paper prints (Table 1): cylinders with their chamfers folded in.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/shaft.h"
#include "engine/core/shaft_step.h"

namespace lathelier::cad {

/// Cylinders of the outside. A cone is folded into the cylinder that its large end meets when its role is "chamfer", or
/// without a role when it is short, 15° to 75° steep and ends at a face.
std::vector<ShaftStep> stepsOf(const Shaft& shaft);

/// The rows (from 0) that have no place among the steps: cones, arcs, faces of undercuts. To be listed beside.
std::vector<std::size_t> rowsBesideSteps(const Shaft& shaft);

}  // namespace lathelier::cad
