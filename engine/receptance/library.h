// Built-in libraries of materials and machines: default values until measured ones are stated. Files as
// io::readLibrary(): "materials" with the fields of Material, "machines" with those of SpindleSprings.
#pragma once

#include <string>
#include <vector>

#include "engine/core/library.h"
#include "engine/core/material.h"
#include "engine/receptance/spindle_receptance.h"

namespace lathelier::receptance {

/// Errors with line and column: malformed, keyMissing, keyOutOfRange. The name of a material is its key.
std::vector<LibraryEntry<Material>> readMaterials(const std::string& json);
std::vector<LibraryEntry<SpindleSprings>> readMachines(const std::string& json);

}  // namespace lathelier::receptance
