// Built-in library of inserts on common holders. File as io::readLibrary(): "inserts" with the fields of ToolGeometry.
// It holds no cutting coefficients, which belong to the pair of material and insert.
#pragma once

#include <string>
#include <vector>

#include "engine/core/library.h"
#include "engine/cutting/cutting_forces.h"

namespace lathelier::cutting {

/// Errors with line and column: malformed, keyMissing, keyOutOfRange.
std::vector<LibraryEntry<ToolGeometry>> readInserts(const std::string& json);

}  // namespace lathelier::cutting
