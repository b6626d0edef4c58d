#include "engine/io/cloud/ply_header.h"

#include <algorithm>
#include <array>

#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::size_t longestPlyHeader = std::size_t{1} << 20;

using Words = std::vector<std::string_view>;

std::string_view wordAt(const Words& words, std::size_t i, std::string_view line)
{
    return i < words.size() ? words[i] : line.substr(line.size());
}

std::optional<PlyType> plyTypeOf(std::string_view word)
{
    struct Named {
        std::string_view word;
        PlyType type;
    };
    static constexpr std::array<Named, 16> names = {{{"char", PlyType::Int8},
                                                     {"int8", PlyType::Int8},
                                                     {"uchar", PlyType::UInt8},
                                                     {"uint8", PlyType::UInt8},
                                                     {"short", PlyType::Int16},
                                                     {"int16", PlyType::Int16},
                                                     {"ushort", PlyType::UInt16},
                                                     {"uint16", PlyType::UInt16},
                                                     {"int", PlyType::Int32},
                                                     {"int32", PlyType::Int32},
                                                     {"uint", PlyType::UInt32},
                                                     {"uint32", PlyType::UInt32},
                                                     {"float", PlyType::Float},
                                                     {"float32", PlyType::Float},
                                                     {"double", PlyType::Double},
                                                     {"float64", PlyType::Double}}};
    for (const Named& named : names)
        if (word == named.word) return named.type;
    return std::nullopt;
}

PlyType readType(const Lines& lines, const Words& words, std::size_t i)
{
    const std::string_view word = wordAt(words, i, lines.line());
    if (const auto type = plyTypeOf(word)) return *type;
    throw malformed(lines.number(), lines.line(), word, LT_TEXT("Engine", "a PLY type such as float or uchar"));
}

PlyFormat readFormat(const Lines& lines, const Words& words)
{
    const std::string_view word = wordAt(words, 1, lines.line());
    if (word == "ascii") return PlyFormat::Ascii;
    if (word == "binary_little_endian") return PlyFormat::LittleEndian;
    if (word == "binary_big_endian") return PlyFormat::BigEndian;
    throw malformed(lines.number(), lines.line(), word,
                    LT_TEXT("Engine", "ascii, binary_little_endian or binary_big_endian"));
}

PlyElement readElement(const Lines& lines, const Words& words)
{
    const std::string_view count = wordAt(words, 2, lines.line());
    const auto number = wholeInteger(count);
    if (!number || *number < 0)
        throw malformed(lines.number(), lines.line(), count, LT_TEXT("Engine", "the number of elements"));
    return {std::string(words[1]), static_cast<std::uint64_t>(*number), {}};
}

PlyProperty readProperty(const Lines& lines, const Words& words)
{
    PlyProperty property;
    property.is_list = wordAt(words, 1, lines.line()) == "list";
    const std::size_t at = property.is_list ? 3 : 1;
    if (property.is_list) {
        property.count_type = readType(lines, words, 2);
        if (property.count_type == PlyType::Float || property.count_type == PlyType::Double)
            throw malformed(lines.number(), lines.line(), words[2], LT_TEXT("Engine", "a whole-number PLY type"));
    }
    property.type = readType(lines, words, at);
    const std::string_view name = wordAt(words, at + 1, lines.line());
    if (name.empty())
        throw malformed(lines.number(), lines.line(), name, LT_TEXT("Engine", "the name of the property"));
    property.name = lowerCase(name);
    return property;
}

}  // namespace

bool PlyElement::hasList() const
{
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& property) { return property.is_list; });
}

std::size_t PlyElement::stride() const
{
    std::size_t bytes = 0;
    for (const PlyProperty& property : properties) bytes += sizeOf(property.type);
    return bytes;
}

int PlyElement::indexOf(std::string_view wanted) const
{
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == wanted) return static_cast<int>(i);
    return -1;
}

std::size_t sizeOf(PlyType type)
{
    switch (type) {
        case PlyType::Int8:
        case PlyType::UInt8: return 1;
        case PlyType::Int16:
        case PlyType::UInt16: return 2;
        case PlyType::Int32:
        case PlyType::UInt32:
        case PlyType::Float: return 4;
        case PlyType::Double: return 8;
    }
    return 0;
}

bool startsLikePly(std::string_view bytes)
{
    return bytes.size() > 3 && (bytes.starts_with("ply") || bytes.starts_with("PLY")) &&
           (isBlank(bytes[3]) || bytes[3] == '\n' || bytes[3] == '\r');
}

PlyHeader readPlyHeader(std::string_view bytes)
{
    PlyHeader header;
    bool hasFormat = false;
    Lines lines(bytes.substr(0, longestPlyHeader));
    lines.next();
    if (!startsLikePly(bytes))  // selected by its file name only
        throw malformed(lines.number(), lines.line(), lines.line(), LT_TEXT("Engine", "ply"));
    Words words;
    while (lines.next()) {
        splitWords(lines.line(), words);
        if (words.empty()) continue;
        const std::string_view word = words[0];
        if (word == "comment" || word == "obj_info") {
            if (!header.unit) header.unit = statedUnit(lines.line().substr(word.size()));
            header.comment_lines.push_back(lines.number());
            header.synthetic = header.synthetic || (words.size() > 1 && words[1].starts_with("synthetic"));
        } else if (word == "format") {
            header.format = readFormat(lines, words);
            hasFormat = true;
        } else if (word == "element") {
            if (words.size() < 3)
                throw malformed(lines.number(), lines.line(), wordAt(words, 2, lines.line()),
                                LT_TEXT("Engine", "the number of elements"));
            header.elements.push_back(readElement(lines, words));
        } else if (word == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(readProperty(lines, words));
        } else if (word == "end_header") {
            if (!hasFormat)
                throw malformed(lines.number(), lines.line(), word, LT_TEXT("Engine", "a line that states the format"));
            header.body_offset = lines.nextOffset();
            header.body_line = lines.number() + 1;
            // With lone CRs as line ends, a line feed behind the last one is data already.
            const bool loneCr = bytes.size() > 4 && bytes[3] == '\r' && bytes[4] != '\n';
            if (loneCr && header.body_offset >= 2 && bytes[header.body_offset - 1] == '\n') --header.body_offset;
            return header;
        } else {
            throw malformed(lines.number(), lines.line(), word, LT_TEXT("Engine", "a line of a PLY header"));
        }
    }
    throw malformedEnd(lines, LT_TEXT("Engine", "end_header"));
}

}  // namespace lathelier::io
