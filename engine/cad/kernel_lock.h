// OpenCASCADE keeps its STEP settings globally per process: readers and writers must hold this lock.
#pragma once

#include <mutex>

namespace lathelier::cad {

std::mutex& kernelMutex();

}  // namespace lathelier::cad
