// The shaft as the table of steps of the paper (Table 1): cylinders with their chamfers.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/json.h"
#include "engine/shaft/shaft.h"
#include "engine/shaft/shaft_step.h"

namespace lathelier::cad {

/// Cylinders of the outside. A cone is a chamfer of the cylinder at its large end if its role is "chamfer", or without
/// a role if it is short, 15° to 75° steep and ends at a face.
std::vector<ShaftStep> stepsOf(const Shaft& shaft);

/// The same as a list of objects, {x_mm, y_mm, radius_mm, z_start_mm, z_end_mm, chamfer_start_mm, chamfer_end_mm}.
Json stepsJson(const Shaft& shaft);

/// Indices (from 0) of the rows that are not steps: cones, arcs, faces of undercuts.
std::vector<std::size_t> rowsBesideSteps(const Shaft& shaft);

}  // namespace lathelier::cad
