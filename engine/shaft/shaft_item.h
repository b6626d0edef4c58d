// A shaft as an item of the project: one panel describes it, others work on it. Its values are toValues(shaft).
#pragma once

#include <optional>
#include <string>

#include "engine/shaft/shaft.h"

namespace lathelier {

inline constexpr const char* shaftItem = "shaft";  ///< kind of the item

/// The shaft again; nothing when the values are not those of a shaft with at least one segment.
std::optional<Shaft> shaftOf(const Values& values);

}  // namespace lathelier
