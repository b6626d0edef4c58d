// OpenCASCADE keeps its settings for STEP in one place for the whole process: who reads or writes takes this lock.
#pragma once

#include <mutex>

namespace lathelier::cad {

std::mutex& kernelMutex();

}  // namespace lathelier::cad
