// Data of a recognition that refit() needs.
#pragma once

#include <Eigen/Geometry>

#include "engine/features/outline/dimensions.h"
#include "engine/features/outline/outline.h"

namespace lathelier::features {

struct RecognitionBasis {
    Outline outside;                ///< fitted, with its walls
    Eigen::Isometry3d axis_T_scan;  ///< into the frame of the outline
    double coverage_deg = 360;      ///< of the circle
    AddedUncertainty added;         ///< to every U
};

}  // namespace lathelier::features
