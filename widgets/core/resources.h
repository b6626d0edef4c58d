// Icons and translations inside the program.
#pragma once

namespace lathelier {

/// Makes ":/icons" and ":/translations" readable. A static library's resources have to be asked for by name.
void useResources();

}  // namespace lathelier
