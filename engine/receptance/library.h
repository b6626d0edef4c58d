// Built-in libraries of materials and machines: default values until measured ones are stated. Files as
// io::readLibrary(): "materials" with the fields of Material, "machines" with those of SpindleSprings.
#pragma once

#include <string>
#include <vector>

#include "engine/core/built_in_text.h"
#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/library.h"
#include "engine/core/material.h"
#include "engine/receptance/spindle/spindle_receptance.h"
#include "engine/shaft/shaft.h"

namespace lathelier::receptance {

/// Errors with line and column: malformed, keyMissing, keyOutOfRange. The name of a material is its key.
std::vector<LibraryEntry<Material>> readMaterials(const std::string& json);
std::vector<LibraryEntry<SpindleSprings>> readMachines(const std::string& json);

/// resources/library/materials.json and machines.json.
const std::vector<BuiltInText>& builtInModels();

/// The entries that are built in. Thread-safe.
const std::vector<LibraryEntry<Material>>& materials();
const std::vector<LibraryEntry<SpindleSprings>>& machines();

/// Shown name of an entry: of a known key in the reader's language, else the key.
Text nameOfMaterial(const std::string& key);
Text nameOfMachine(const std::string& key);

/// The material of the library where one is chosen by its key, with the note materialOfLibrary.
bool chooseMaterial(const std::string& choice, Shaft& shaft, Notes& notes);

/// Entries as choices of a field; the first one, "stated", is called `stated`.
std::vector<FieldChoice> materialChoices(Text stated);
std::vector<FieldChoice> machineChoices(Text stated);

}  // namespace lathelier::receptance
