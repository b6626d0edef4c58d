// The shaft as the table of steps that the paper prints (Table 1): cylinders with their chamfers folded in.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/shaft.h"

namespace lathelier::cad {

struct Step {
    double x_mm = 0, y_mm = 0;            ///< of its centre; 0 on the axis of the shaft
    double radius_mm = 0;                 ///< in mm
    double z_start_mm = 0, z_end_mm = 0;  ///< to the outer ends of its chamfers
    double chamfer_start_mm = 0;          ///< leg along z; 0: none
    double chamfer_end_mm = 0;            ///< leg along z
    friend bool operator==(const Step&, const Step&) = default;
};

/// Cylinders of the outside. A cone is folded into the cylinder that its large end meets when its role is "chamfer", or
/// without a role when it is short, 15° to 75° steep and ends at a face.
std::vector<Step> stepsOf(const Shaft& shaft);

/// The rows (from 0) that have no place among the steps: cones, arcs, faces of undercuts. To be listed beside.
std::vector<std::size_t> rowsBesideSteps(const Shaft& shaft);

}  // namespace lathelier::cad
