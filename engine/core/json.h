// Values, errors and notes as JSON. Only .cpp files include <nlohmann/json.hpp>.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "engine/core/error.h"
#include "engine/core/value.h"

namespace lathelier {

using Json = nlohmann::ordered_json;  ///< keys stay in the order they were written

Json number(double value);  ///< null when it is not finite: the number does not exist
Json number(const std::optional<double>& value);
Json numbers(std::span<const double> values);
Json numbers(const Eigen::Vector2d& vector);
Json numbers(const Eigen::Vector3d& vector);
Json toJson(const Value& value);  ///< numbers as above; intervals are [[from, to], …], rows [{…}, …]
Json toJson(const Values& values);
Json toJson(const Notes& notes);  ///< [{"code": "…", named values…}, …]
Json toJson(const Error& error);  ///< {"code": "…", named values…}

/// The reverse, for project files. What has no place in Value becomes "not given".
Value valueFromJson(const Json& json);
Values valuesFromJson(const Json& json);

}  // namespace lathelier
