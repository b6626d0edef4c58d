// Built-in library of inserts on common holders. File as io::readLibrary(): "inserts" with the fields of ToolGeometry.
// It holds no cutting coefficients, which belong to the pair of material and insert.
#pragma once

#include <string>
#include <vector>

#include "engine/core/built_in_text.h"
#include "engine/core/fields.h"
#include "engine/core/library.h"
#include "engine/cutting/cutting_forces.h"

namespace lathelier::cutting {

/// Errors with line and column: malformed, keyMissing, keyOutOfRange.
std::vector<LibraryEntry<ToolGeometry>> readInserts(const std::string& json);

/// resources/library/inserts.json.
const std::vector<BuiltInText>& builtInInserts();

/// The entries that are built in. Thread-safe.
const std::vector<LibraryEntry<ToolGeometry>>& inserts();

/// "CNMG 120404, 95°".
Text nameOfInsert(const std::string& key);

/// Entries as choices of a field; the first one, "stated", is called `stated`.
std::vector<FieldChoice> insertChoices(Text stated);

}  // namespace lathelier::cutting
