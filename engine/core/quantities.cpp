#include "engine/core/quantities.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lathelier {
namespace {

Json listJson(const Rows& rows)
{
    Json result = Json::array();
    for (const Row& row : rows.rows) result.push_back(nestedJson(row.cells));
    return result;
}

}  // namespace

Json nestedJson(const Values& values)
{
    Json result = Json::object();
    for (const auto& [key, value] : values) {
        Json* place = &result;
        std::size_t from = 0;
        bool absent = false;
        for (std::size_t dot = key.find('.'); dot != std::string::npos && !absent; dot = key.find('.', from)) {
            place = &(*place)[key.substr(from, dot - from)];
            absent = place->is_null() && find(values, std::string_view(key).substr(0, dot)) != nullptr;
            from = dot + 1;
        }
        if (absent) continue;
        Json& member = (*place)[key.substr(from)];
        const std::string within = key + ".";
        const bool is_part = std::any_of(values.begin(), values.end(),
                                         [&within](const auto& other) { return other.first.starts_with(within); });
        if (is_part)
            member = std::get<bool>(value) ? Json::object() : Json(nullptr);
        else if (const Rows* rows = std::get_if<Rows>(&value))
            member = listJson(*rows);
        else
            member = toJson(value);
    }
    return result;
}

namespace detail {

QuantityInfo within(const QuantityInfo& info, const std::string& part)
{
    QuantityInfo result = info;
    result.key = part + "." + info.key;
    return result;
}

}  // namespace detail
}  // namespace lathelier
