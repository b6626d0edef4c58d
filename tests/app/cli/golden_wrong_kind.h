// Files of the wrong kind, for the golden lines that refuse them.
#pragma once

#include <string>

namespace lathelier::golden {

/// Adds tables of other quantities, programs, meshes that are none, Q-DAS files and links to the folder.
void makeWrongKinds(const std::string& folder);

}  // namespace lathelier::golden
