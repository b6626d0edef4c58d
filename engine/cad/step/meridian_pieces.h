// Pieces of a meridian that coaxial faces show, and which of them bound the turned body.
//
// A face that runs all round belongs to the turned body. One that covers less than the whole circle either belongs to
// it and is interrupted by a cut (a keyway, a hole), or bounds the cut itself: the floor of a slot across an end, the
// wall at the end of a flat, the root of a spline, the ground of a hole. Covered angle: area over that of the whole
// surface of revolution (Pappus).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/cad/step_faces.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {

struct MeridianPiece {
    ContourPiece curve;     ///< directed with the material on its right
    bool cylinder = false;  ///< its radius is that of the cylindrical surface
    std::vector<std::size_t> faces;
    bool whole = true;  ///< runs all round; set by keepTurned()
};

/// Leaves out the pieces that bound cuts only, and extends faces across the axis that cuts interrupt to the next edge
/// of the turned body, else to the axis.
void keepTurned(std::vector<MeridianPiece>& pieces, const std::vector<StepFace>& faces);

}  // namespace lathelier::cad
