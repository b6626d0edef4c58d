// Facts of a file as JSON, for the command `inspect`.
#pragma once

#include "engine/core/json.h"
#include "engine/io/import.h"

namespace lathelier::io {

/// path, format, encoding, delimiter, decimal, unit, unit_source, rows, columns, skipped [{line, reason}], details;
/// inapplicable entries are null.
Json toJson(const FileFacts& facts);

}  // namespace lathelier::io
