// What was understood of a file, as the command line's `inspect` writes it.
#pragma once

#include "engine/core/json.h"
#include "engine/io/import.h"

namespace lathelier::io {

/// path, format, encoding, delimiter, decimal, unit, unit_source, rows, columns, skipped [{line, reason}], details;
/// what does not apply is null.
Json toJson(const FileFacts& facts);

}  // namespace lathelier::io
