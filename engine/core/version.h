// The version of the program, as project() in CMakeLists.txt states it.
#pragma once

namespace lathelier {

/// "1.2.3"
extern const char* const programVersion;

}  // namespace lathelier
