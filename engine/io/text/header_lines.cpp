#include "engine/io/text/header_lines.h"

#include <cmath>

#include "engine/io/table/table_cell.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr std::size_t mostEntries = 200;
constexpr std::size_t longestKey = 60;
constexpr std::size_t longestValue = 1000;
constexpr std::size_t mostWordsInKey = 3;

bool isKeyByte(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// True when ", key=" starts at `at`: the comma ends a value.
bool startsNextKey(std::string_view line, std::size_t at)
{
    std::size_t p = at + 1;
    while (p < line.size() && isBlank(line[p])) ++p;
    const std::size_t begin = p;
    while (p < line.size() && isKeyByte(line[p])) ++p;
    if (p == begin || (line[begin] >= '0' && line[begin] <= '9')) return false;
    while (p < line.size() && isBlank(line[p])) ++p;
    return p < line.size() && line[p] == '=';
}

/// A name of up to three words that starts with a letter.
bool isKey(std::string_view key)
{
    if (key.empty() || key.size() > longestKey || !isKeyByte(key.front()) || key.front() == '.' ||
        (key.front() >= '0' && key.front() <= '9'))
        return false;
    std::vector<std::string_view> words;
    splitWords(key, words);
    return words.size() <= mostWordsInKey;
}

void addPair(std::string_view part, Values& header)
{
    part = trimmed(part);
    std::size_t mark = part.find('=');
    if (mark == std::string_view::npos) mark = part.find(':');
    if (mark == std::string_view::npos) mark = part.find('\t');
    if (mark == std::string_view::npos || header.size() >= mostEntries) return;
    const std::string_view key = trimmed(part.substr(0, mark));
    const std::string_view value = trimmed(part.substr(mark + 1));
    if (!isKey(key) || value.empty() || value.size() > longestValue) return;
    set(header, key, std::string(value));
}

void addHeaderLine(std::string_view line, Values& header)
{
    line = trimmed(line);
    while (!line.empty() && std::string_view("#/%!;*").find(line.front()) != std::string_view::npos)
        line.remove_prefix(1);
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '(' || c == '[') ++depth;
        if ((c == ')' || c == ']') && depth > 0) --depth;
        if (depth > 0 || !(c == ';' || (c == ',' && startsNextKey(line, i)))) continue;
        addPair(line.substr(begin, i - begin), header);
        begin = i + 1;
    }
    addPair(line.substr(begin), header);
}

}  // namespace

Values readHeaderLines(std::string_view text, std::size_t bodyOffset)
{
    Values header;
    Lines lines(text.substr(0, bodyOffset));
    while (header.size() < mostEntries && lines.next())
        if (lines.line().size() <= 8 * longestValue) addHeaderLine(lines.line(), header);
    return header;
}

const std::string* headerWord(const Values& header, std::string_view key)
{
    const std::string wanted = lowerCase(key);
    for (const auto& [name, value] : header)
        if (lowerCase(name) == wanted) return std::get_if<std::string>(&value);
    return nullptr;
}

std::optional<double> headerNumber(const Values& header, std::string_view key)
{
    const std::string* const word = headerWord(header, key);
    if (!word) return std::nullopt;
    const std::string_view number = std::string_view(*word).substr(0, word->find_first_of(" \t("));
    const Evidence evidence = evidenceOf(number).evidence;
    if (evidence == Evidence::NoNumber || evidence == Evidence::LoneComma) return std::nullopt;
    const CellValue value = readCell(number, {' ', evidence == Evidence::Comma ? ',' : '.', false, false});
    if (value.kind != CellKind::Number || !std::isfinite(value.value)) return std::nullopt;
    return value.value;
}

}  // namespace lathelier::io
