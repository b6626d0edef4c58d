#include "engine/core/texts.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/core/visible.h"

namespace lathelier {
namespace {

std::string number(double value, const Language& language)
{
    return language.number ? language.number(value) : fmt::format("{:.6g}", value);
}

/// Path, line, column, byte of an error, as far as they are there.
std::string place(const Values& values, const Language& language)
{
    const bool line = find(values, "line");
    const bool column = find(values, "column");
    const bool byte = find(values, "byte");
    std::string result;
    const auto add = [&](Text pattern) {
        if (!result.empty()) result += ", ";
        result += fill(text(pattern, language), values, language);
    };
    if (const Value* path = find(values, "path")) result = text(*path, language);
    if (line) add(LT_TEXT("Engine", "line {line}"));
    if (column) add(LT_TEXT("Engine", "column {column}"));
    if (byte) add(LT_TEXT("Engine", "byte {byte}"));
    return result;
}

}  // namespace

std::string text(Text english, const Language& language)
{
    if (english.empty()) return {};
    return language.translate ? language.translate(english.english) : std::string(english.english);
}

std::string text(const Value& value, const Language& language)
{
    struct Visitor {
        const Language& language;
        std::string operator()(std::monostate) const { return {}; }
        std::string operator()(bool v) const
        {
            return text(v ? LT_TEXT("Engine", "yes") : LT_TEXT("Engine", "no"), language);
        }
        std::string operator()(std::int64_t v) const { return std::to_string(v); }
        std::string operator()(double v) const { return number(v, language); }
        std::string operator()(const std::string& v) const { return visible(v); }
        std::string operator()(const std::vector<Interval>& v) const
        {
            std::string result;
            for (const Interval& interval : v) {
                if (!result.empty()) result += ", ";
                result += number(interval.from, language) + ":" + number(interval.to, language);
            }
            return result;
        }
        std::string operator()(Text v) const { return text(v, language); }
        std::string operator()(const std::vector<double>& v) const
        {
            std::string result;
            for (const double value : v) result += (result.empty() ? "" : ", ") + number(value, language);
            return result;
        }
        std::string operator()(const std::vector<std::int64_t>& v) const
        {
            std::string result;
            for (const std::int64_t value : v) result += (result.empty() ? "" : ", ") + std::to_string(value);
            return result;
        }
        std::string operator()(const Rows& v) const
        {
            std::string result;
            for (const Row& row : v.rows) {
                if (!result.empty()) result += "; ";
                std::string line;
                for (const auto& [name, cell] : row.cells) line += (line.empty() ? "" : ", ") + text(cell, language);
                result += line;
            }
            return result;
        }
    };
    return std::visit(Visitor{language}, value);
}

std::string text(const Error& error, const Language& language)
{
    const std::string where = place(error.values(), language);
    const std::string what = fill(text(error.code().pattern, language), error.values(), language);
    return where.empty() ? what : where + ": " + what;
}

std::string text(const Note& note, const Language& language)
{
    return fill(text(note.code.pattern, language), note.values, language);
}

std::string fixed(double value, int decimals, const Language& language)
{
    if (!std::isfinite(value)) return {};
    if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0;
    return language.fixed ? language.fixed(value, decimals) : fmt::format("{:.{}f}", value, decimals);
}

std::string fill(const std::string& pattern, const Values& values, const Language& language)
{
    std::string result;
    std::size_t from = 0;
    while (from < pattern.size()) {
        const std::size_t open = pattern.find('{', from);
        const std::size_t close = open == std::string::npos ? open : pattern.find('}', open);
        if (close == std::string::npos) break;
        result.append(pattern, from, open - from);
        const Value* value = find(values, std::string_view(pattern).substr(open + 1, close - open - 1));
        const std::string word = value ? text(*value, language) : pattern.substr(open, close - open + 1);
        if (word.empty() && result.ends_with(' ')) result.pop_back();  // a unit that there is none of
        result += word;
        from = close + 1;
    }
    return result.append(pattern, from, std::string::npos);
}

}  // namespace lathelier
