// Icons, translations and libraries inside the program.
#pragma once

#include <string>

namespace lathelier {

/// Makes ":/icons" and ":/translations" readable. A static library's resources have to be asked for by name.
void useResources();

/// The content of ":/library/…"; empty when there is no such resource. Safe from any thread.
std::string resourceText(const char* path);

}  // namespace lathelier
