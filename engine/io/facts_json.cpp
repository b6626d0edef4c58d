#include "engine/io/facts_json.h"

#include <nlohmann/json.hpp>

namespace lathelier::io {
namespace {

Json wordOrNull(const std::string& word)
{
    return word.empty() ? Json() : Json(word);
}
Json countOrNull(std::int64_t count)
{
    return count == 0 ? Json() : Json(count);
}

}  // namespace

Json toJson(const FileFacts& facts)
{
    Json json;
    json["path"] = facts.path;
    json["format"] = wordOrNull(facts.format);
    json["encoding"] = wordOrNull(facts.encoding);
    json["delimiter"] = wordOrNull(facts.delimiter);
    json["decimal"] = wordOrNull(facts.decimal);
    json["unit"] = wordOrNull(facts.unit);
    json["unit_source"] = wordOrNull(facts.unit_source);
    json["rows"] = countOrNull(facts.rows);
    json["columns"] = countOrNull(facts.columns);
    json["skipped"] = Json::array();
    for (const SkippedRow& row : facts.skipped)
        json["skipped"].push_back({{"line", row.line}, {"reason", row.reason.english}});
    json["details"] = facts.details.empty() ? Json::object() : toJson(facts.details);
    if (facts.min_mm) json["details"]["min_mm"] = *facts.min_mm;
    if (facts.max_mm) json["details"]["max_mm"] = *facts.max_mm;
    return json;
}

}  // namespace lathelier::io
