#include "app/cli/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lathelier::cli {
namespace {

std::string scalar(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool isFlat(const Json& array)
{
    return std::none_of(array.begin(), array.end(), [](const Json& item) { return item.is_structured(); });
}

/// Numbers in pairs and the like also stay on one line.
bool isShort(const Json& array)
{
    return std::all_of(array.begin(), array.end(), [](const Json& item) { return item.is_array() && isFlat(item); });
}

/// An array on one line.
void writeFlat(const Json& array, std::string& out)
{
    out += '[';
    bool first = true;
    for (const Json& item : array) {
        if (!first) out += ", ";
        first = false;
        if (item.is_array())
            writeFlat(item, out);
        else
            out += scalar(item);
    }
    out += ']';
}

void write(const Json& json, const std::string& indent, std::string& out)
{
    if (!json.is_structured() || json.empty()) {
        out += scalar(json);
        return;
    }
    if (json.is_array() && (isFlat(json) || isShort(json))) return writeFlat(json, out);
    const std::string inner = indent + "  ";
    out += json.is_array() ? "[\n" : "{\n";
    std::size_t left = json.size();
    for (auto item = json.begin(); item != json.end(); ++item) {
        out += inner;
        if (json.is_object()) out += scalar(item.key()) + ": ";
        write(*item, inner, out);
        out += --left > 0 ? ",\n" : "\n";
    }
    out += indent + (json.is_array() ? "]" : "}");
}

}  // namespace

std::string toText(const Json& json)
{
    std::string result;
    write(json, "", result);
    return result + "\n";
}

}  // namespace lathelier::cli
