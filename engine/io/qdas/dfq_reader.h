// Reads the Q-DAS ASCII transfer format.
#pragma once

#include <string>
#include <string_view>

#include "engine/io/import.h"
#include "engine/io/qdas/dfq.h"

namespace lathelier::io {

/// Reads what toDfq() writes, and its kin: K-fields for values, or the short lines of values (characteristics parted by
/// 0x0F, what belongs to a value by 0x14). Errors malformed (line), fileEmpty, formatUnknown.
QdasFile readDfq(const std::string& name, std::string_view bytes);

/// What `inspect` says of such a file: format "qdas", details "parts", "characteristics", "values", "part_number"…
/// Errors of readDfq().
FileFacts readDfqFacts(const std::string& name, std::string_view bytes);

/// True when a file is Q-DAS by its first field (its name may promise it, and not keep it).
bool isDfq(std::string_view bytes);

}  // namespace lathelier::io
