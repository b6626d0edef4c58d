// Why a STEP file's solid is no turned part, with its worst faces.
#pragma once

#include <vector>

#include "engine/cad/step_faces.h"
#include "engine/cad/step_meridian.h"
#include "engine/cad/step_reader.h"
#include "engine/core/error.h"

namespace lathelier::cad {

/// Range of the boundary of a face in z and r about an axis.
struct FaceExtent {
    double z_low = 0, z_high = 0, r_low = 0, r_high = 0;
};

FaceExtent extentOf(const StepFace& face, const Line3& axis);

/// The largest first; z from `free_end_mm` on the axis.
std::vector<OtherFace> describeFaces(const StepSolid& solid, const std::vector<std::size_t>& which, const Line3& axis,
                                     double free_end_mm);

/// Throws notABodyOfRevolution where no axis is to be looked for: all faces are planes. Reason prismatic: up to six
/// directions of planes; else faceted.
void refusePlanes(const StepSolid& solid);

/// Throws notABodyOfRevolution without an axis: reason free_form or no_single_axis.
[[noreturn]] void refuseWithoutAxis(const StepSolid& solid);

/// Throws notABodyOfRevolution. Reason and faces, the first that applies:
///   eccentric       round cylinders or cones of more than half a turn beside the axis, material inside (`offset_mm`)
///   prismatic       planes along the axis that are larger than the turned outside, or bound a stretch of the part that
///                   has no turned face
///   not_round       the curved faces are mostly turned
///   no_single_axis  else
[[noreturn]] void refuseSolid(const StepSolid& solid, const Meridian& meridian, const Line3& axis);

}  // namespace lathelier::cad
