// Reads the Q-DAS ASCII transfer format.
#pragma once

#include <string>
#include <string_view>

#include "engine/io/import.h"
#include "engine/io/qdas/dfq.h"

namespace lathelier::io {

/// Reads files written by toDfq() and similar ones: K-fields for values, or short lines of values (characteristics
/// separated by 0x0F, parts of a value by 0x14). Errors malformed (line), fileEmpty, formatUnknown.
QdasFile readDfq(const std::string& name, std::string_view bytes);

/// Facts for `inspect`: format "qdas", details "parts", "characteristics", "values", "part_number"… Errors of
/// readDfq().
FileFacts readDfqFacts(const std::string& name, std::string_view bytes);

/// True when a file is Q-DAS by its first field (independent of its name).
bool isDfq(std::string_view bytes);

}  // namespace lathelier::io
