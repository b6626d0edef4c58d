// Values, errors and notes as JSON. Only .cpp files include <nlohmann/json.hpp>.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/core/error.h"
#include "engine/core/value.h"

namespace lathelier {

using Json = nlohmann::ordered_json;  ///< keys stay in the order they were written

Json toJson(const Value& value);  ///< a number that does not exist is null; intervals are [[from, to], …]
Json toJson(const Values& values);
Json toJson(const Notes& notes);  ///< [{"code": "…", named values…}, …]
Json toJson(const Error& error);  ///< {"code": "…", named values…}

/// The reverse, for project files. What has no place in Value becomes "not given".
Value valueFromJson(const Json& json);
Values valuesFromJson(const Json& json);

}  // namespace lathelier
