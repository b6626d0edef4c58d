#include "engine/core/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace lathelier {

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json number(const std::optional<double>& value)
{
    return value ? number(*value) : Json(nullptr);
}

Json numbers(std::span<const double> values)
{
    Json json = Json::array();
    for (const double value : values) json.push_back(number(value));
    return json;
}

Json numbers(const Eigen::Vector2d& vector)
{
    return numbers(std::span(vector.data(), 2));
}

Json numbers(const Eigen::Vector3d& vector)
{
    return numbers(std::span(vector.data(), 3));
}

Json toJson(const Value& value)
{
    struct Visitor {
        Json operator()(std::monostate) const { return nullptr; }
        Json operator()(bool v) const { return v; }
        Json operator()(std::int64_t v) const { return v; }
        Json operator()(double v) const { return number(v); }
        Json operator()(const std::string& v) const { return v; }
        Json operator()(const std::vector<Interval>& v) const
        {
            Json result = Json::array();
            for (const Interval& interval : v) result.push_back({interval.from, interval.to});
            return result;
        }
        Json operator()(Text v) const { return v.english; }
        Json operator()(const std::vector<double>& v) const { return numbers(v); }
        Json operator()(const std::vector<std::int64_t>& v) const { return v; }
        Json operator()(const Rows& v) const
        {
            Json result = Json::array();
            for (const Row& row : v.rows) result.push_back(toJson(row.cells));
            return result;
        }
    };
    return std::visit(Visitor{}, value);
}

Json toJson(const Values& values)
{
    Json result = Json::object();
    for (const auto& [name, value] : values) result[name] = toJson(value);
    return result;
}

Json toJson(const Notes& notes)
{
    Json result = Json::array();
    for (const Note& note : notes) {
        Json item{{"code", note.code.key}};
        item.update(toJson(note.values));
        result.push_back(std::move(item));
    }
    return result;
}

Json toJson(const Error& error)
{
    Json result{{"code", error.code().key}};
    result.update(toJson(error.values()));
    return result;
}

namespace {

bool isPair(const Json& item)
{
    return item.is_array() && item.size() == 2 && item[0].is_number() && item[1].is_number();
}

/// A list of pairs is ranges (so is an empty one), of numbers numbers, of objects rows; others have no place in Value.
Value listFromJson(const Json& json)
{
    const auto all = [&json](auto is) { return std::all_of(json.begin(), json.end(), is); };
    if (all(isPair)) {
        std::vector<Interval> intervals;
        for (const Json& item : json) intervals.push_back({item[0].get<double>(), item[1].get<double>()});
        return intervals;
    }
    if (all([](const Json& item) { return item.is_number(); })) return json.get<std::vector<double>>();
    if (!all([](const Json& item) { return item.is_object(); })) return {};
    Rows rows;
    for (const Json& item : json) rows.rows.push_back({valuesFromJson(item)});
    return rows;
}

}  // namespace

Value valueFromJson(const Json& json)
{
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_number_integer()) return json.get<std::int64_t>();
    if (json.is_number()) return json.get<double>();
    if (json.is_string()) return json.get<std::string>();
    if (json.is_array()) return listFromJson(json);
    return {};
}

Values valuesFromJson(const Json& json)
{
    Values result;
    if (json.is_object())
        for (const auto& [name, value] : json.items()) result.emplace_back(name, valueFromJson(value));
    return result;
}

}  // namespace lathelier
