// Holes of full circle in a turned part: cross holes, whose axis meets that of the part at a right angle, and axial
// holes beside its axis, with their counterbores, countersinks and drill points.
#pragma once

#include <vector>

#include "engine/cad/step/cut_volume.h"
#include "engine/cad/step/face_shape.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

struct NamedCuts {
    std::vector<ShaftMark> marks;
    std::vector<ConvexCut> cuts;
    std::vector<bool> named;  ///< of the faces given
};

/// Marks cross_hole; axial holes of one size that divide their circle equally are one bolt_circle, others one each
/// with `count` 1. A cross hole from one side that ends in a bore has its depth to the bore and is not through.
NamedCuts holesOf(const std::vector<FaceShape>& faces, const Shaft& turned);

/// Largest radius of the outside at this z; 0 beyond its ends.
double outerRadius_mm(const Shaft& turned, double z_mm);

}  // namespace lathelier::cad
