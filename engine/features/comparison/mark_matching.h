// Marks of a drawing that are, or are not, in a recognised copy.
#pragma once

#include <Eigen/Geometry>

#include "engine/core/error.h"
#include "engine/features/recognition.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// Which marks of the drawing the copy has: those of the same kind whose middle lies on them. `nominal_T_part` as in
/// compareRows(). Sizes of marks are not compared. Notes markNotFound for each that is missing,
/// marksNotCompared for the others; none where the drawing has no marks.
Notes notesOfMarks(const Shaft& nominal, const Recognition& measured, const Eigen::Isometry3d& nominal_T_part);

}  // namespace lathelier::features
