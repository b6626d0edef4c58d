#include "engine/io/frf/uff_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/units.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"

namespace lathelier::io {
namespace {

using UffKind = UffColumn::Kind;

constexpr Text expectedNumber = LT_TEXT("Engine", "a number in its columns");

/// The value of a word, NaN for words such as "NaN"; none for others and on overflow.
std::optional<double> wordNumber(std::string_view word)
{
    if (const auto value = wholeNumber(word, '.')) return std::isfinite(*value) ? value : std::nullopt;
    if (isNotFiniteWord(word)) return notANumber;
    return std::nullopt;
}

std::size_t widthInBytes(std::string_view text, int characters, bool countBytes)
{
    if (countBytes) return std::min(text.size(), static_cast<std::size_t>(characters));
    std::size_t bytes = 0;
    for (int k = 0; k < characters && bytes < text.size(); ++k) {
        ++bytes;
        while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) ++bytes;
    }
    return bytes;
}

std::vector<std::string_view> split(std::string_view line, std::span<const UffColumn> columns, bool countBytes)
{
    std::vector<std::string_view> parts;
    for (const UffColumn& column : columns) {
        const std::size_t width = widthInBytes(line, column.width, countBytes);
        parts.push_back(line.substr(0, width));
        line.remove_prefix(width);
    }
    return parts;
}

std::optional<double> numberIn(std::string_view part, UffKind kind)
{
    part = trimmed(part);
    if (part.empty() || kind == UffKind::Word) return 0;
    if (kind == UffKind::Blank) return std::nullopt;
    if (kind == UffKind::Real) return wholeNumber(part, '.');
    const auto integer = wholeInteger(part);
    return integer ? std::optional(static_cast<double>(*integer)) : std::nullopt;
}

/// Index of the first field with invalid content, including blanks between texts; columns.size() when all are valid.
std::size_t firstWrong(std::span<const std::string_view> parts, std::span<const UffColumn> columns)
{
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (!numberIn(parts[k], columns[k].kind)) return k;
    return parts.size();
}

/// All words of a line are numbers, but not in the columns: a free layout of another program.
bool readWords(std::string_view line, std::span<const int> widths, std::vector<double>& values)
{
    std::vector<std::string_view> words;
    splitWords(line, words);
    bool aligned = true;
    std::vector<double> found;
    for (const std::string_view word : words) {
        const auto value = wordNumber(word);
        if (!value) return false;
        found.push_back(*value);
        const auto end = static_cast<std::size_t>(word.data() - line.data()) + word.size();
        std::size_t boundary = 0;
        for (std::size_t k = 0; boundary < end && k < widths.size(); ++k)
            boundary += static_cast<std::size_t>(widths[k]);
        aligned = aligned && boundary == end;
    }
    if (aligned) return false;
    values.insert(values.end(), found.begin(), found.end());
    return true;
}

}  // namespace

std::string uffText(std::string_view line)
{
    try {
        return std::string(decodeText(line, Encoding::Auto).view());
    } catch (const Error&) {
        return std::string(decodeText(line, Encoding::Latin1).view());
    }
}

UffFields::UffFields(std::int64_t lineNumber, std::string_view line, std::span<const UffColumn> columns)
    : lineNumber_(lineNumber), line_(uffText(line))
{
    parts_ = split(line_, columns, false);
    if (firstWrong(parts_, columns) < columns.size()) {
        std::vector<std::string_view> byBytes = split(line_, columns, true);
        if (firstWrong(byBytes, columns) == columns.size()) parts_ = std::move(byBytes);
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const auto number = numberIn(parts_[k], columns[k].kind);
        const bool counts = columns[k].kind != UffKind::Blank;  // characters in a gap do not affect numbers
        if (counts && (!number || !std::isfinite(*number))) throw wrong(k, expectedNumber);
        numbers_.push_back(number.value_or(0));
    }
}

std::int64_t UffFields::begin(std::size_t k) const
{
    const std::string_view text = trimmed(parts_[k]);
    const std::string_view before(line_.data(), static_cast<std::size_t>(text.data() - line_.data()));
    return 1 + std::count_if(before.begin(), before.end(),
                             [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

Error UffFields::wrong(std::size_t k, Text expected) const
{
    return malformed(lineNumber_, line_, trimmed(parts_[k]), expected);
}

void readUffNumbers(std::int64_t lineNumber, std::string_view line, std::span<const int> widths,
                    std::vector<double>& values)
{
    const std::string_view written = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    if (readWords(written, widths, values)) return;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < widths.size() && begin < written.size(); ++k) {
        const std::string_view part = trimmed(written.substr(begin, static_cast<std::size_t>(widths[k])));
        const auto value = wordNumber(part);
        if (!value) throw malformed(lineNumber, line, part, expectedNumber);
        values.push_back(*value);
        begin += static_cast<std::size_t>(widths[k]);
    }
    const std::string_view rest = trimmed(written.substr(std::min(begin, written.size())));
    if (!rest.empty()) throw malformed(lineNumber, line, rest, LT_TEXT("Engine", "the end of the line"));
}

bool isUffSeparator(std::string_view line)
{
    if (line.size() < 2) return false;
    const std::size_t at = line.find("-1");
    if (at != 4 && at != 0) return false;
    return trimmed(line.substr(0, at)).empty() && trimmed(line.substr(at + 2)).empty();
}

}  // namespace lathelier::io
