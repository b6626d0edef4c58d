// A library of inserts on common holders, to begin with. File as io::readLibrary(): "inserts" with the fields of
// ToolGeometry. What an insert is made of is no part of it: cutting coefficients belong to the pair of material and
// insert, and stay where they are stated.
#pragma once

#include <string>
#include <vector>

#include "engine/core/library.h"
#include "engine/cutting/cutting_forces.h"

namespace lathelier::cutting {

/// Errors with line and column: malformed, keyMissing, keyOutOfRange.
std::vector<LibraryEntry<ToolGeometry>> readInserts(const std::string& json);

}  // namespace lathelier::cutting
