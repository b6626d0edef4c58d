// A shaft among the values of another item of the project, such as a job that holds its part: a table of one row.
#pragma once

#include <optional>

#include "engine/shaft/shaft.h"

namespace lathelier {

Value shaftAsValue(const Shaft& shaft);

/// The inverse; nothing when it is not one row with the values of a shaft.
std::optional<Shaft> shaftOf(const Value& value);

}  // namespace lathelier
