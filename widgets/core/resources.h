// Embedded resources: icons, translations, pages of the manual and lessons.
#pragma once

#include <string>

namespace lathelier {

/// Makes ":/icons" and ":/translations" readable. Resources of a static library must be initialised explicitly.
void useResources();

/// The content of ":/training/…"; empty when there is no such resource. Thread-safe.
std::string resourceText(const char* path);

}  // namespace lathelier
