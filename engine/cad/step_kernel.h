// Functions of the module lathelier-occt with OpenCASCADE: reading the faces of a solid, revolving a contour.
#pragma once

#include "engine/cad/step_faces.h"
#include "engine/cad/step_solid.h"

namespace lathelier::cad {

struct StepKernel {
    decltype(&readStepFaces) read_faces;
    decltype(&revolvedStep) revolved;
};

// Both in the module, under names of their own.
StepSolid readStepFacesByKernel(std::string_view bytes, const Part21& checked, const Progress& progress);
std::string revolvedStepByKernel(const Contour& closed, StepSchema schema, const ExpectedVolume& expected,
                                 const Progress& progress);

}  // namespace lathelier::cad
