#include "engine/cad/step_kernel.h"

#include "engine/core/module.h"

namespace lathelier::cad {
namespace {

const StepKernel& kernel()
{
    static const auto& table = moduleTable<StepKernel>("lathelier-occt", "lathelier_step_kernel");
    return table;
}

}  // namespace

StepSolid readStepFaces(std::string_view bytes, const Part21& checked, const Progress& progress)
{
    return kernel().read_faces(bytes, checked, progress);
}

std::string revolvedStep(const Contour& closed, StepSchema schema, const ExpectedVolume& expected,
                         const Progress& progress)
{
    return kernel().revolved(closed, schema, expected, progress);
}

}  // namespace lathelier::cad
