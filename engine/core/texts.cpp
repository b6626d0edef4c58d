#include "engine/core/texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "engine/core/significant_digits.h"
#include "engine/core/visible.h"

namespace lathelier {
namespace {

std::string numberText(double value, const Language& language)
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

/// Rounds a converted number to its significant digits: 0.1 mm is 0.003937 in.
double readable(double converted)
{
    if (converted == 0 || !std::isfinite(converted)) return converted;
    const double digit = std::pow(10, 4 - std::floor(std::log10(std::abs(converted))));
    return std::round(converted * digit) / digit;
}

/// {name}, {name:+3} or {name:3+} of a pattern.
struct Brace {
    std::size_t begin = 0, end = 0;  ///< in the pattern, braces included
    std::string_view name;
    std::optional<int> decimals;  ///< none: as the number needs
    bool is_signed = false;       ///< "+" is written
    bool is_least = false;        ///< more decimals where a small value needs them for three digits
};

std::optional<Brace> nextBrace(std::string_view pattern, std::size_t from)
{
    const std::size_t open = pattern.find('{', from);
    const std::size_t close = open == std::string_view::npos ? open : pattern.find('}', open);
    if (close == std::string_view::npos) return std::nullopt;
    Brace brace{open, close + 1, pattern.substr(open + 1, close - open - 1), {}};
    const std::size_t colon = brace.name.find(':');
    if (colon == std::string_view::npos) return brace;
    std::string_view digits = brace.name.substr(colon + 1);
    brace.name = brace.name.substr(0, colon);
    brace.is_signed = digits.starts_with('+');
    if (brace.is_signed) digits.remove_prefix(1);
    brace.is_least = digits.ends_with('+');
    int decimals = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), decimals).ec == std::errc())
        brace.decimals = decimals;
    return brace;
}

Text unitOfName(std::string_view name)
{
    if (name.ends_with("_mm")) return millimetre;
    if (name.ends_with("_um")) return micrometre;
    return {};
}

/// Which units of a pattern are shown in another.
struct Lengths {
    bool mm = false, um = false;
    bool has(Text unit) const { return unit == millimetre ? mm : unit == micrometre && um; }
};

/// A value that is no number (a phrase with its own unit) leaves the pattern in the engine's units.
Lengths lengthsOf(std::string_view pattern, const Values& values, const Language& language)
{
    Lengths found;
    if (language.lengths.unit.empty() && language.deviations_of_form.unit.empty()) return found;
    bool mixed = false;
    std::size_t from = 0;
    for (std::optional<Brace> brace; (brace = nextBrace(pattern, from)); from = brace->end) {
        const Text unit = unitOfName(brace->name);
        const Value* value = unit.empty() ? nullptr : find(values, brace->name);
        if (!value) continue;
        mixed = mixed || !std::holds_alternative<double>(*value);
        (unit == millimetre ? found.mm : found.um) = true;
    }
    return mixed ? Lengths{} : found;
}

bool isPartOfWord(std::string_view around, std::size_t at)
{
    if (at >= around.size()) return false;
    const auto c = static_cast<unsigned char>(around[at]);
    return std::isalnum(c) != 0 || c == '/' || c == '_';
}

/// The words "mm" and "µm" of a piece of a pattern as the units that are shown.
std::string withUnits(std::string piece, const Lengths& lengths, const Language& language)
{
    for (const Text unit : {millimetre, micrometre}) {
        if (!lengths.has(unit)) continue;
        const std::string_view word = unit.english;
        const std::string shown = text(shownUnit(unit, language).unit, language);
        std::size_t from = 0;
        for (std::size_t at = 0; (at = piece.find(word, from)) != std::string::npos;) {
            from = at + word.size();
            const bool squared = std::string_view(piece).substr(from).starts_with("²");
            if ((at > 0 && isPartOfWord(piece, at - 1)) || isPartOfWord(piece, from) || squared) continue;
            piece.replace(at, word.size(), shown);
            from = at + shown.size();
        }
    }
    return piece;
}

/// The value of a brace. Numbers of lengths as they are shown.
std::string textOfBrace(const Value& value, const Brace& brace, const Lengths& lengths, const Language& language)
{
    const double* const exact = std::get_if<double>(&value);
    if (!exact) return text(value, language);
    const Text unit = unitOfName(brace.name);
    const ShownUnit shown = lengths.has(unit) ? shownUnit(unit, language) : ShownUnit{};
    const double size = *exact * shown.factor;
    const std::string sign = brace.is_signed && size > 0 ? "+" : "";
    if (!brace.decimals) return sign + numberText(size, language);
    const int decimals = brace.is_least ? decimalsOfThreeDigits(size, *brace.decimals) : *brace.decimals;
    return sign + fixed(size, std::max(0, decimals + shown.more_decimals), language);
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
        std::string operator()(double v) const { return numberText(v, language); }
        std::string operator()(const std::string& v) const { return visible(v); }
        std::string operator()(const std::vector<Interval>& v) const
        {
            std::string result;
            for (const Interval& interval : v) {
                if (!result.empty()) result += ", ";
                result += numberText(interval.from, language) + ":" + numberText(interval.to, language);
            }
            return result;
        }
        std::string operator()(Text v) const { return text(v, language); }
        std::string operator()(const std::vector<double>& v) const
        {
            std::string result;
            for (const double value : v) result += (result.empty() ? "" : ", ") + numberText(value, language);
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
    const Lengths lengths = lengthsOf(pattern, values, language);
    std::string result;
    const auto append = [&](std::size_t from, std::size_t to) {
        result += withUnits(pattern.substr(from, to - from), lengths, language);
    };
    std::size_t from = 0;
    for (std::optional<Brace> brace; (brace = nextBrace(pattern, from)); from = brace->end) {
        append(from, brace->begin);
        const Value* value = find(values, brace->name);
        const std::string word = value ? textOfBrace(*value, *brace, lengths, language)
                                       : pattern.substr(brace->begin, brace->end - brace->begin);
        if (word.empty() && result.ends_with(' ')) result.pop_back();  // an empty value takes the blank before it away
        result += word;
    }
    append(from, pattern.size());
    return result;
}

ShownUnit shownUnit(Text unit, const Language& language)
{
    if (unit == millimetre && !language.lengths.unit.empty()) return language.lengths;
    if (unit == micrometre && !language.deviations_of_form.unit.empty()) return language.deviations_of_form;
    return {unit};
}

std::string shownNumber(double value, Text unit, int decimals, const Language& language)
{
    const ShownUnit shown = shownUnit(unit, language);
    return fixed(value * shown.factor, std::max(0, decimals + shown.more_decimals), language);
}

Value shownValue(const Value& value, Text unit, const Language& language)
{
    const double factor = shownUnit(unit, language).factor;
    if (factor == 1) return value;
    if (const double* number = std::get_if<double>(&value)) return readable(*number * factor);
    if (const auto* list = std::get_if<std::vector<double>>(&value)) {
        std::vector<double> shown = *list;
        for (double& number : shown) number = readable(number * factor);
        return shown;
    }
    if (const auto* ranges = std::get_if<std::vector<Interval>>(&value)) {
        std::vector<Interval> shown = *ranges;
        for (Interval& range : shown) range = {readable(range.from * factor), readable(range.to * factor)};
        return shown;
    }
    return value;
}

Language inEngineUnits(Language language)
{
    language.lengths = {};
    language.deviations_of_form = {};
    return language;
}

}  // namespace lathelier
