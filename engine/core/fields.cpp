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
        case FieldInfo::Kind::Flag:
        case FieldInfo::Kind::Group: return LT_TEXT("Engine", "yes or no");
        case FieldInfo::Kind::Integer: return LT_TEXT("Engine", "a whole number");
        case FieldInfo::Kind::Number: return LT_TEXT("Engine", "a number");
        case FieldInfo::Kind::Choice: return LT_TEXT("Engine", "one of the choices");
        case FieldInfo::Kind::Word: return LT_TEXT("Engine", "a text");
        case FieldInfo::Kind::Intervals: return LT_TEXT("Engine", "ranges such as 10:20,35:40");
        case FieldInfo::Kind::Rows: return LT_TEXT("Engine", "a list of rows");
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

/// An error in a row has `row`, counted from 1, and the key of table and column.
void checkRow(const FieldInfo& info, const Row& row, std::size_t index)
{
    for (const FieldInfo& column : info.columns)
        if (const Value* cell = find(row.cells, column.key)) {
            FieldInfo named = column;
            named.key = info.key + "[" + std::to_string(index + 1) + "]." + column.key;
            check(named, *cell);
        }
}

void checkRows(const FieldInfo& info, const Value& value)
{
    const Rows* table = std::get_if<Rows>(&value);
    const auto* ranges = std::get_if<std::vector<Interval>>(&value);  // an empty JSON list has no element type
    if (!table && !(ranges && ranges->empty())) reject(info, value);
    checkRange(info, table ? static_cast<double>(table->rows.size()) : 0);
    if (!table) return;
    for (std::size_t i = 0; i < table->rows.size(); ++i) checkRow(info, table->rows[i], i);
}

Rows parseRows(const FieldInfo& info, std::string_view typed)
{
    Rows result;
    const std::string_view between = info.columns.size() == 1 ? ";," : ";";  // a list of single values
    const std::string_view within =
        std::all_of(info.columns.begin(), info.columns.end(),
                    [](const FieldInfo& column) { return column.kind == FieldInfo::Kind::Number; })
            ? ",:"
            : ",";
    while (!typed.empty()) {
        const std::size_t end = std::min(typed.find_first_of(between), typed.size());
        std::string_view line = typed.substr(0, end);
        Row row;
        for (const FieldInfo& column : info.columns) {
            const std::size_t comma = std::min(line.find_first_of(within), line.size());
            const std::string_view cell = line.substr(0, comma);
            FieldInfo named = column;
            named.key = info.key + "[" + std::to_string(result.rows.size() + 1) + "]." + column.key;
            if (cell.empty() && column.required) reject(info, std::string(typed.substr(0, end)));
            if (!cell.empty()) row.cells.emplace_back(column.key, parse(named, std::string(cell)));
            line.remove_prefix(std::min(comma + 1, line.size()));
        }
        if (!line.empty()) reject(info, std::string(typed.substr(0, end)));
        result.rows.push_back(std::move(row));
        typed.remove_prefix(std::min(end + 1, typed.size()));
    }
    return result;
}

}  // namespace

bool isImplied(const FieldInfo& group, const Values& values)
{
    if (group.kind != FieldInfo::Kind::Group) return false;
    const std::string within = group.key + ".";
    return std::any_of(values.begin(), values.end(), [&](const auto& item) {
        return item.first.starts_with(within) && !std::holds_alternative<std::monostate>(item.second);
    });
}

FieldInfo asFormer(const FieldInfo& info, const FormerKey& former)
{
    FieldInfo result = info;
    result.key = former.key;
    if (former.complement) {
        result.minimum = *former.complement - info.maximum;
        result.maximum = *former.complement - info.minimum;
    }
    return result;
}

void takeFormer(const FieldInfo& info, Values& values)
{
    const auto at = [&values](const std::string& key) {
        return std::find_if(values.begin(), values.end(), [&key](const auto& item) { return item.first == key; });
    };
    for (const FormerKey& former : info.former) {
        const Value* word = former.where.first.empty() ? nullptr : find(values, former.where.first);
        if (!former.where.first.empty() && (!word || !(*word == Value(former.where.second)))) continue;
        auto stated = at(former.key);
        if (stated == values.end()) continue;
        Value value = std::move(stated->second);
        values.erase(stated);
        const auto today = at(info.key);
        const bool is_there = today != values.end() && !std::holds_alternative<std::monostate>(today->second);
        const bool is_blank =
            is_there && former.blank && holdsNumber(today->second) && detail::asDouble(today->second) == *former.blank;
        if (is_blank) today->second = {};
        if (std::holds_alternative<std::monostate>(value)) continue;
        if (is_there && !is_blank) throw Error(errors::valueStatedTwice, {{"former", former.key}, {"key", info.key}});
        if (former.complement && holdsNumber(value)) value = *former.complement - detail::asDouble(value);
        set(values, info.key, std::move(value));
    }
}

void check(const FieldInfo& info, const Value& value)
{
    if (std::holds_alternative<std::monostate>(value)) {
        if (!info.optional && info.group_key.empty()) reject(info, value);
        return;
    }
    switch (info.kind) {
        case FieldInfo::Kind::Flag:
        case FieldInfo::Kind::Group:
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
            if (!key || (!info.is_open && std::none_of(info.choices.begin(), info.choices.end(),
                                                       [&](const FieldChoice& choice) { return choice.key == *key; })))
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
        case FieldInfo::Kind::Rows: checkRows(info, value); break;
    }
}

Value parse(const FieldInfo& info, const std::string& typed)
{
    Value value;
    switch (info.kind) {
        case FieldInfo::Kind::Flag:
        case FieldInfo::Kind::Group:
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
        case FieldInfo::Kind::Rows: value = parseRows(info, typed); break;
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
    info.required = label.required;
    info.minimum = range.minimum;
    info.maximum = range.maximum;
    return info;
}

FieldInfo within(const FieldInfo& info, const std::string& key, Text heading, const std::string& group_key)
{
    FieldInfo result = info;
    result.key = key + "." + info.key;
    if (result.group.empty()) result.group = heading;
    result.group_key = info.group_key.empty() ? group_key : key + "." + info.group_key;
    for (FormerKey& former : result.former) {
        former.key = key + "." + former.key;
        if (!former.where.first.empty()) former.where.first = key + "." + former.where.first;
    }
    return result;
}

double asDouble(const Value& value)
{
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    return std::get<double>(value);
}

}  // namespace detail
}  // namespace lathelier
