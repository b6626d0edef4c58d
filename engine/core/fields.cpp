#include "engine/core/fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"

namespace lathelier {
namespace {

Text expectation(const FieldInfo& info)
{
    switch (info.kind) {
        case FieldInfo::Kind::Flag: return LT_TEXT("Engine", "yes or no");
        case FieldInfo::Kind::Integer: return LT_TEXT("Engine", "a whole number");
        case FieldInfo::Kind::Number: return LT_TEXT("Engine", "a number");
        case FieldInfo::Kind::Choice: return LT_TEXT("Engine", "one of the choices");
        case FieldInfo::Kind::Word: return LT_TEXT("Engine", "a text");
        case FieldInfo::Kind::Intervals: return LT_TEXT("Engine", "ranges such as 10:20,35:40");
    }
    return {};
}

[[noreturn]] void reject(const FieldInfo& info, const Value& found)
{
    Values values{{"parameter", info.key}, {"found", found}, {"expected", expectation(info)}};
    if (!info.choices.empty()) {
        std::string choices;
        for (const FieldChoice& choice : info.choices) choices += (choices.empty() ? "" : " | ") + choice.key;
        set(values, "expected", choices);
    }
    throw Error(errors::valueNotUnderstood, values);
}

void checkRange(const FieldInfo& info, double number)
{
    if (!(number >= info.minimum && number <= info.maximum))
        throw Error(errors::valueOutOfRange, {{"parameter", info.key},
                                              {"found", number},
                                              {"expected", expectation(info)},
                                              {"minimum", info.minimum},
                                              {"maximum", info.maximum}});
}

bool holdsNumber(const Value& value)
{
    return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
}

double parseNumber(const FieldInfo& info, std::string_view typed)
{
    double number = 0;
    const char* end = typed.data() + typed.size();
    const auto [stop, problem] = std::from_chars(typed.data(), end, number);
    if (problem != std::errc() || stop != end || !std::isfinite(number)) reject(info, std::string(typed));
    return number;
}

std::vector<Interval> parseIntervals(const FieldInfo& info, std::string_view typed)
{
    std::vector<Interval> result;
    while (!typed.empty()) {
        const std::size_t comma = std::min(typed.find(','), typed.size());
        const std::string_view item = typed.substr(0, comma);
        const std::size_t colon = item.find(':');
        if (colon == std::string_view::npos) reject(info, std::string(item));
        result.push_back({parseNumber(info, item.substr(0, colon)), parseNumber(info, item.substr(colon + 1))});
        typed.remove_prefix(std::min(comma + 1, typed.size()));
    }
    return result;
}

}  // namespace

void check(const FieldInfo& info, const Value& value)
{
    if (std::holds_alternative<std::monostate>(value)) {
        if (!info.optional) reject(info, value);
        return;
    }
    switch (info.kind) {
        case FieldInfo::Kind::Flag:
            if (!std::holds_alternative<bool>(value)) reject(info, value);
            break;
        case FieldInfo::Kind::Integer:
            if (!std::holds_alternative<std::int64_t>(value)) reject(info, value);
            checkRange(info, static_cast<double>(std::get<std::int64_t>(value)));
            break;
        case FieldInfo::Kind::Number:
            if (!holdsNumber(value)) reject(info, value);
            checkRange(info, detail::asDouble(value));
            break;
        case FieldInfo::Kind::Choice: {
            const auto* key = std::get_if<std::string>(&value);
            if (!key || std::none_of(info.choices.begin(), info.choices.end(),
                                     [&](const FieldChoice& choice) { return choice.key == *key; }))
                reject(info, value);
            break;
        }
        case FieldInfo::Kind::Word:
            if (!std::holds_alternative<std::string>(value)) reject(info, value);
            break;
        case FieldInfo::Kind::Intervals: {
            const auto* intervals = std::get_if<std::vector<Interval>>(&value);
            if (!intervals) reject(info, value);
            for (const Interval& interval : *intervals) {
                checkRange(info, interval.from);
                checkRange(info, interval.to);
                if (interval.from > interval.to && !info.wraps) reject(info, value);
            }
            break;
        }
    }
}

Value parse(const FieldInfo& info, const std::string& typed)
{
    Value value;
    switch (info.kind) {
        case FieldInfo::Kind::Flag:
            if (typed != "yes" && typed != "no" && typed != "true" && typed != "false") reject(info, typed);
            value = typed == "yes" || typed == "true";
            break;
        case FieldInfo::Kind::Integer: {
            const double number = parseNumber(info, typed);
            if (number != std::floor(number)) reject(info, typed);
            checkRange(info, number);
            value = static_cast<std::int64_t>(number);
            break;
        }
        case FieldInfo::Kind::Number: value = parseNumber(info, typed); break;
        case FieldInfo::Kind::Choice:
        case FieldInfo::Kind::Word: value = typed; break;
        case FieldInfo::Kind::Intervals: value = parseIntervals(info, typed); break;
    }
    check(info, value);
    return value;
}

namespace detail {

FieldInfo makeInfo(const char* key, FieldInfo::Kind kind, const Label& label, Range range)
{
    FieldInfo info;
    info.key = key;
    info.kind = kind;
    info.label = label.label;
    info.help = label.help;
    info.unit = label.unit;
    info.advanced = label.advanced;
    info.minimum = range.minimum;
    info.maximum = range.maximum;
    return info;
}

double asDouble(const Value& value)
{
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    return std::get<double>(value);
}

}  // namespace detail
}  // namespace lathelier
