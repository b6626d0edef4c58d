// A STEP file (ISO 10303-21) of a turned part as a shaft: the common axis of the largest curved area, the meridian of
// the coaxial faces, and the faces that are not of revolution.
//
// Every coaxial face gives a piece of the meridian, directed with the material on its right; pieces of one line or
// circle that touch are one (faces split by seams or sectors). The pieces are chained to the closed meridian, whose
// outside becomes the rows and whose inside the bores: the smallest turned body around the solid. Accepted is
//   a pure body of revolution, whose volume agrees with that of the solid;
//   a turned body from which marks are cut: all of the solid lies within it, every other face is part of a cut, and the
//   volume of the named cuts is the volume that the solid lacks (3 %). Where faces are of free form
//   V_solid / V_table >= 0.9 is asked instead, which alone is no guard: an eccentric pin passes it as a cone.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// A face that is not part of the meridian.
struct OtherFace {
    Text kind;  ///< "plane", "cylinder"…
    double area_mm2 = 0;
    double z_start_mm = 0, z_end_mm = 0;  ///< along the part, from its free end
};

struct StepPart {
    Shaft shaft;  ///< its name is the product's; marks as step/step_marks.h
    /// The frame of the shaft in the file: its free end's centre, and the direction toward the chuck.
    Eigen::Vector3d free_end_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector toward the chuck
    double volume_mm3 = 0;  ///< of the solid in the file; of splines that are turned surfaces, of these
    double cut_mm3 = 0;     ///< of the turned body without marks, less that of the solid
    double named_mm3 = 0;   ///< of the cuts of the marks that are named, within 5e-3
    std::vector<OtherFace> other_faces;
};

/// The free end is not stated in a file: the axis points to the side of its largest coordinate. Notes: notOfRevolution,
/// those of checkShaft(). Errors: fileEmpty, formatUnknown; malformed with `line` and `column`; stepTooLarge, noSolid,
/// severalParts; notABodyOfRevolution with `reason` (step/step_refusal.h) and up to four worst faces as `faces`. 20-30
/// ms for a part of 30 faces. Throws Cancelled.
StepPart readStep(std::string_view bytes, Notes& notes, const Progress& progress = {});

/// True if the head of a file is that of STEP.
bool looksLikeStep(std::string_view head);

}  // namespace lathelier::cad
