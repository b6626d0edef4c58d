#include "engine/cad/kernel_lock.h"

namespace lathelier::cad {

std::mutex& kernelMutex()
{
    static std::mutex mutex;
    return mutex;
}

}  // namespace lathelier::cad
