// Members that are not known are refused, for files whose every word counts: recipes, configurations.
#pragma once

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/io/json/json_fields.h"

namespace lathelier::io {

/// Only these members. Else an error of `unknown` with line, column, key, expected.
void requireMembers(const JsonCursor& object, const std::vector<std::string>& known, const ErrorCode& unknown);

/// As valuesOf(), but a member that is not described is an error of `unknown` with line, column, key and `expected`.
Values strictValuesOf(const JsonCursor& object, const std::vector<FieldInfo>& fields, const Value& expected,
                      const ErrorCode& unknown);

}  // namespace lathelier::io
