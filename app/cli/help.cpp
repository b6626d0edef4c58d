#include "app/cli/help.h"

#include <algorithm>
#include <sstream>

#include "engine/core/texts.h"

namespace lathelier::cli {
namespace {

constexpr std::size_t textWidth = 72;

bool isNumeric(const FieldInfo& info)
{
    return info.kind == FieldInfo::Kind::Number || info.kind == FieldInfo::Kind::Integer ||
           info.kind == FieldInfo::Kind::Intervals;
}

/// "length_mm,diameter_mm[;...]"
std::string rowPlaceholder(const FieldInfo& info)
{
    std::string result;
    for (const FieldInfo& column : info.columns) result += (result.empty() ? "" : ",") + column.key;
    return result + "[;...]";
}

}  // namespace

std::string placeholder(const FieldInfo& info)
{
    switch (info.kind) {
        case FieldInfo::Kind::Flag:
        case FieldInfo::Kind::Group: return {};
        case FieldInfo::Kind::Integer: return "N";
        case FieldInfo::Kind::Number: return "NUMBER";
        case FieldInfo::Kind::Word: return "TEXT";
        case FieldInfo::Kind::Intervals: return "A:B[,C:D...]";
        case FieldInfo::Kind::Rows: return rowPlaceholder(info);
        case FieldInfo::Kind::Choice: break;
    }
    std::string choices;
    for (const FieldChoice& choice : info.choices) {
        if (!choices.empty()) choices += '|';
        choices += choice.key;
    }
    if (info.is_open) choices += "|FILE";
    return choices;
}

std::string describe(const Option& option)
{
    const FieldInfo& info = option.info;
    std::string result = text(info.help.empty() ? info.label : info.help);
    std::string facts;
    const auto add = [&facts](const std::string& fact) {
        if (!facts.empty()) facts += "; ";
        facts += fact;
    };
    if (isNumeric(info)) {
        std::string range = text(Value(info.minimum)) + " to " + text(Value(info.maximum));
        if (!info.unit.empty()) range.append(" ").append(text(info.unit));
        add(range);
    }
    const bool is_flag = info.kind == FieldInfo::Kind::Flag || info.kind == FieldInfo::Kind::Group;
    if (const std::string standard = text(option.standard); !standard.empty() && !is_flag) add("default " + standard);
    return wrapHelp(facts.empty() ? result : result + " [" + facts + "]");
}

std::string wrapHelp(const std::string& text)
{
    std::istringstream words(text);
    std::string result;
    std::size_t used = 0;
    for (std::string word; words >> word;) {
        if (used > 0 && used + 1 + word.size() > textWidth) {
            result += '\n';
            used = 0;
        } else if (used > 0) {
            result += ' ';
            ++used;
        }
        result += word;
        used += word.size();
    }
    return result;
}

}  // namespace lathelier::cli
