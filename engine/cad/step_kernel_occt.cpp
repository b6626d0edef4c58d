#include "engine/cad/kernel_lock.h"
#include "engine/cad/step_kernel.h"

namespace lathelier::cad {

std::mutex& kernelMutex()
{
    static std::mutex mutex;
    return mutex;
}

}  // namespace lathelier::cad

extern "C" {
extern const lathelier::cad::StepKernel lathelier_step_kernel;
const lathelier::cad::StepKernel lathelier_step_kernel{lathelier::cad::readStepFacesByKernel,
                                                       lathelier::cad::revolvedStepByKernel};
}
