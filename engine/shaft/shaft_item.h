// A shaft as an item of the project: one panel describes it, others work on it. Its values are toValues(shaft).
#pragma once

#include <optional>
#include <string>

#include "engine/shaft/shaft.h"

namespace lathelier {

inline constexpr const char* shaftItem = "shaft";  ///< kind of the item

/// What a shaft was recovered from, kept with the item for title blocks. Beside the keys of the shaft.
struct RecoveredFrom {
    std::string scan;         ///< name of the file
    std::string scan_sha256;  ///< of its content, lower-case hexadecimal
    std::string method;       ///< of the recognition: "robust"
    friend bool operator==(const RecoveredFrom&, const RecoveredFrom&) = default;
};

/// Values of the item.
Values itemValues(const Shaft& shaft, const RecoveredFrom& from);

/// Nothing where the shaft was not recovered from a scan.
std::optional<RecoveredFrom> recoveredFrom(const Values& values);

/// The shaft again; nothing when the values are not those of a shaft with at least one segment.
std::optional<Shaft> shaftOf(const Values& values);

}  // namespace lathelier
