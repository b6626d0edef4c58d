#include "engine/io/text/units.h"

#include <array>
#include <cctype>
#include <vector>

#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

struct LengthWord {
    std::string_view word;
    std::string_view key;
    double mm;
};

constexpr LengthWord lengthWords[] = {
    {"mm", "mm", 1},
    {"millimetre", "mm", 1},
    {"millimetres", "mm", 1},
    {"millimeter", "mm", 1},
    {"millimeters", "mm", 1},
    {"milimetr", "mm", 1},
    {"milimetry", "mm", 1},
    {"мм", "mm", 1},
    {"m", "m", 1000},
    {"metre", "m", 1000},
    {"metres", "m", 1000},
    {"meter", "m", 1000},
    {"meters", "m", 1000},
    {"metr", "m", 1000},
    {"metry", "m", 1000},
    {"м", "m", 1000},
    {"in", "inch", 25.4},
    {"in.", "inch", 25.4},
    {"inch", "inch", 25.4},
    {"inches", "inch", 25.4},
    {"zoll", "inch", 25.4},
    {"cal", "inch", 25.4},
    {"cale", "inch", 25.4},
    {"pollici", "inch", 25.4},
    {"\"", "inch", 25.4},
    {"дюйм", "inch", 25.4},
    {"um", "um", 1e-3},
    {"µm", "um", 1e-3},
    {"μm", "um", 1e-3},
    {"micron", "um", 1e-3},
    {"microns", "um", 1e-3},
    {"micrometre", "um", 1e-3},
    {"micrometres", "um", 1e-3},
    {"micrometer", "um", 1e-3},
    {"micrometers", "um", 1e-3},
    {"мкм", "um", 1e-3},
    {"cm", "cm", 10},
    {"centimetre", "cm", 10},
    {"centimetres", "cm", 10},
    {"centimeter", "cm", 10},
    {"centimeters", "cm", 10},
    {"см", "cm", 10},
    {"dm", "dm", 100},
    {"nm", "nm", 1e-6},
    {"ft", "ft", 304.8},
    {"foot", "ft", 304.8},
    {"feet", "ft", 304.8},
    {"mil", "mil", 0.0254},
    {"mils", "mil", 0.0254},
    {"thou", "mil", 0.0254},
};

bool isWordByte(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

/// The words of a remark, in lower case; a quote mark denoting inch is a word too.
std::vector<std::string> wordsOf(std::string_view remark)
{
    std::vector<std::string> words;
    for (std::size_t i = 0; i < remark.size() && words.size() < 200;) {
        if (!isWordByte(remark[i])) {
            ++i;
            continue;
        }
        const std::size_t begin = i;
        while (i < remark.size() && isWordByte(remark[i])) ++i;
        words.push_back(lowerCase(remark.substr(begin, i - begin)));
    }
    return words;
}

template <std::size_t N>
bool isAmong(const std::array<std::string_view, N>& words, const std::string& word)
{
    for (const std::string_view candidate : words)
        if (word == candidate) return true;
    return false;
}

}  // namespace

std::string lowerCase(std::string_view text)
{
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    return result;
}

std::optional<LengthScale> lengthUnit(std::string_view word)
{
    word = trimmed(word);
    if (word.size() > 2 && std::string_view("([{<").find(word.front()) != std::string_view::npos &&
        std::string_view(")]}>").find(word.back()) != std::string_view::npos)
        word = trimmed(word.substr(1, word.size() - 2));
    const std::string lower = lowerCase(word);
    for (const LengthWord& unit : lengthWords)
        if (lower == unit.word) return LengthScale{std::string(unit.key), unit.mm};
    return std::nullopt;
}

std::optional<LengthScale> statedUnit(std::string_view remark)
{
    constexpr std::array<std::string_view, 10> keywords = {"unit",    "units",     "lengthunit", "length_unit",
                                                           "einheit", "einheiten", "jednostka",  "jednostki",
                                                           "unità",   "единицы"};
    constexpr std::array<std::string_view, 7> fillers = {"is", "are", "of", "length", "in", "the", "xyz"};
    constexpr std::array<std::string_view, 8> subjects = {"coordinates", "dimensions", "values", "lengths",
                                                          "points",      "data",       "xyz",    "positions"};
    const std::vector<std::string> words = wordsOf(remark);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (isAmong(keywords, words[i])) {
            // "units are in mm", but "units in" alone means inches: filler words are skipped only if a word follows.
            for (std::size_t k = i + 1; k < words.size() && k <= i + 4; ++k) {
                const bool filler = isAmong(fillers, words[k]) && k + 1 < words.size();
                if (!filler) {
                    if (auto unit = lengthUnit(words[k])) return unit;
                    break;
                }
            }
        }
        if (isAmong(subjects, words[i]))
            for (std::size_t k = i + 1; k + 1 < words.size() && k <= i + 3; ++k)
                if (words[k] == "in")
                    if (auto unit = lengthUnit(words[k + 1])) return unit;
    }
    return std::nullopt;
}

std::optional<LengthScale> lengthScale(LengthUnit unit)
{
    switch (unit) {
        case LengthUnit::Auto: return std::nullopt;
        case LengthUnit::Millimetre: return lengthUnit("mm");
        case LengthUnit::Metre: return lengthUnit("m");
        case LengthUnit::Inch: return lengthUnit("inch");
        case LengthUnit::Micrometre: return lengthUnit("um");
    }
    return std::nullopt;
}

Heading parseHeading(std::string_view cell)
{
    cell = trimmed(cell);
    const auto named = [cell](std::string_view name, std::optional<LengthScale> unit) {
        return Heading{lowerCase(trimmed(name)), std::move(unit), std::string(cell)};
    };
    const std::size_t open = cell.find_first_of("([{<");
    if (open != std::string_view::npos && open > 0) {
        const std::size_t close = cell.find_first_of(")]}>", open);
        return named(cell.substr(0, open),
                     lengthUnit(cell.substr(open + 1, close == std::string_view::npos ? close : close - open - 1)));
    }
    // The last separator before the unit: "x_mm", "X/mm", "X mm", "X in mm", "X,mm", "X-mm", "X.mm".
    const std::size_t mark = cell.find_last_of("_/ ,-.:");
    if (mark != std::string_view::npos && mark > 0)
        if (auto unit = lengthUnit(cell.substr(mark + 1))) {
            std::string_view name = trimmed(cell.substr(0, mark));
            if (lowerCase(name).ends_with(" in")) name.remove_suffix(3);
            return named(name, std::move(unit));
        }
    return named(cell, std::nullopt);
}

}  // namespace lathelier::io
