#include "engine/cad/csv_marks.h"

#include <nlohmann/json.hpp>

#include "engine/io/json/json_fields.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::cad {
namespace {

constexpr std::string_view markPrefix = "mark ";

}  // namespace

std::vector<std::string> markRemarks(const Shaft& shaft)
{
    std::vector<std::string> remarks;
    for (const ShaftMark& mark : shaft.marks) {
        Json json = Json::object();
        const Json all = io::objectOf(infos<ShaftMark>(), toValues(mark));
        for (const auto& [name, value] : all.items())
            if (!value.is_null() && !(value.is_string() && value.get_ref<const std::string&>().empty()))
                json[name] = value;
        remarks.push_back(std::string(markPrefix) + json.dump());
    }
    return remarks;
}

std::vector<ShaftMark> readMarkRemarks(std::string_view text, Notes& notes)
{
    std::vector<ShaftMark> marks;
    for (io::Lines lines(text); lines.next();) {
        std::string_view content = io::trimmed(lines.line());
        if (content.empty() || content.front() != '#') continue;
        content = io::trimmed(content.substr(1));
        if (!content.starts_with(markPrefix)) continue;
        content = io::trimmed(content.substr(markPrefix.size()));
        if (content.empty() || content.front() != '{') continue;  // a remark of a person
        try {
            const io::JsonDocument document{std::string(content)};
            marks.push_back(io::readFields<ShaftMark>(document.root(), notes));
        } catch (Error& error) {
            error.with("line", lines.number());
            throw;
        }
    }
    return marks;
}

}  // namespace lathelier::cad
