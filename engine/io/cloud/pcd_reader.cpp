// PCD files of the Point Cloud Library, versions 0.5 to 0.7: ascii, binary and binary_compressed.
#include "engine/io/cloud/pcd_reader.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/core/parallel.h"
#include "engine/io/cloud/lzf.h"
#include "engine/io/cloud/raw_scan.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/number_cell.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::size_t longestPcdHeader = std::size_t{1} << 20;
constexpr std::int64_t mostBytesPerPoint = std::int64_t{1} << 20;

struct PcdField {
    std::string name;
    std::int64_t size = 4;
    char type = 'F';
    std::int64_t count = 1;
    std::size_t offset = 0;  ///< bytes before it within a point
    std::size_t word = 0;    ///< values before it within a point
};

enum class PcdData { Ascii, Binary, Compressed };

struct PcdHeader {
    std::vector<PcdField> fields;
    std::int64_t points = -1;
    std::int64_t width = -1;
    std::int64_t height = 1;
    PcdData data = PcdData::Ascii;
    std::optional<LengthScale> unit;
    std::size_t body_offset = 0;
    std::int64_t body_line = 1;
    std::size_t stride = 0;  ///< bytes of a point
    std::size_t words = 0;   ///< values of a point

    const PcdField* find(std::string_view name) const
    {
        const auto found =
            std::find_if(fields.begin(), fields.end(), [name](const PcdField& field) { return field.name == name; });
        return found == fields.end() ? nullptr : &*found;
    }
};

using Words = std::vector<std::string_view>;

std::int64_t readCount(const Lines& lines, std::string_view word, std::int64_t largest)
{
    const auto number = wholeInteger(word);
    if (!number || *number < 0 || *number > largest)
        throw malformed(lines.number(), lines.line(), word, LT_TEXT("Engine", "a count"));
    return *number;
}

std::int64_t readOnlyCount(const Lines& lines, const Words& words)
{
    const std::string_view line = lines.line();
    return readCount(lines, words.size() > 1 ? words[1] : line.substr(line.size()),
                     std::numeric_limits<std::int64_t>::max());
}

/// One value for each field: SIZE, TYPE and COUNT.
template <class Store>
void readPerField(const Lines& lines, const Words& words, PcdHeader& header, Store store)
{
    if (words.size() != header.fields.size() + 1)
        throw malformed(lines.number(), lines.line(), lines.line(),
                        LT_TEXT("Engine", "one value for each of the FIELDS"));
    for (std::size_t i = 0; i < header.fields.size(); ++i) store(header.fields[i], words[i + 1]);
}

PcdData readData(const Lines& lines, const Words& words)
{
    const std::string_view word = words.size() > 1 ? words[1] : lines.line().substr(lines.line().size());
    if (word == "ascii") return PcdData::Ascii;
    if (word == "binary") return PcdData::Binary;
    if (word == "binary_compressed") return PcdData::Compressed;
    throw malformed(lines.number(), lines.line(), word, LT_TEXT("Engine", "ascii, binary or binary_compressed"));
}

void finishHeader(const Lines& lines, PcdHeader& header)
{
    for (PcdField& field : header.fields) {
        field.offset = header.stride;
        field.word = header.words;
        header.stride += static_cast<std::size_t>(field.size * field.count);
        header.words += static_cast<std::size_t>(field.count);
        if (header.stride > static_cast<std::size_t>(mostBytesPerPoint))
            throw malformed(lines.number(), lines.line(), lines.line(), LT_TEXT("Engine", "points of at most 1 MiB"));
    }
    for (const char* axis : {"x", "y", "z"}) {
        const PcdField* const field = header.find(axis);
        if (!field || field->count < 1)
            throw malformed(lines.number(), lines.line(), lines.line(),
                            LT_TEXT("Engine", "FIELDS with x, y and z before this line"));
    }
    if (header.points < 0) {
        const bool overflow =
            header.width > 0 && header.height > std::numeric_limits<std::int64_t>::max() / header.width;
        if (header.width < 0 || overflow)
            throw malformed(lines.number(), lines.line(), lines.line(),
                            LT_TEXT("Engine", "POINTS or WIDTH and HEIGHT before this line"));
        header.points = header.width * header.height;
    }
}

PcdHeader readPcdHeader(std::string_view bytes)
{
    PcdHeader header;
    Lines lines(bytes.substr(0, longestPcdHeader));
    Words words;
    while (lines.next()) {
        splitWords(lines.line(), words);
        if (words.empty()) continue;
        const std::string_view key = words[0];
        if (key.front() == '#') {
            if (!header.unit) header.unit = statedUnit(lines.line());
        } else if (key == "FIELDS" || key == "COLUMNS") {
            header.fields.clear();
            for (std::size_t i = 1; i < words.size(); ++i)
                header.fields.push_back({lowerCase(words[i]), 4, 'F', 1, 0, 0});
        } else if (key == "SIZE") {
            readPerField(lines, words, header, [&](PcdField& field, std::string_view word) {
                field.size = readCount(lines, word, 8);
                if (field.size != 1 && field.size != 2 && field.size != 4 && field.size != 8)
                    throw malformed(lines.number(), lines.line(), word, LT_TEXT("Engine", "1, 2, 4 or 8"));
            });
        } else if (key == "TYPE") {
            readPerField(lines, words, header, [&](PcdField& field, std::string_view word) {
                if (word != "F" && word != "I" && word != "U")
                    throw malformed(lines.number(), lines.line(), word, LT_TEXT("Engine", "F, I or U"));
                field.type = word.front();
            });
        } else if (key == "COUNT") {
            readPerField(lines, words, header, [&](PcdField& field, std::string_view word) {
                field.count = readCount(lines, word, mostBytesPerPoint);
            });
        } else if (key == "WIDTH") {
            header.width = readOnlyCount(lines, words);
        } else if (key == "HEIGHT") {
            header.height = readOnlyCount(lines, words);
        } else if (key == "POINTS") {
            header.points = readOnlyCount(lines, words);
        } else if (key == "DATA") {
            header.data = readData(lines, words);
            header.body_offset = lines.nextOffset();
            header.body_line = lines.number() + 1;
            finishHeader(lines, header);
            return header;
        } else if (key != "VERSION" && key != "VIEWPOINT") {
            throw malformed(lines.number(), lines.line(), key, LT_TEXT("Engine", "a line of a PCD header"));
        }
    }
    throw malformedEnd(lines, LT_TEXT("Engine", "a line DATA"));
}

template <class T>
double loadField(const char* from)
{
    T value;
    std::memcpy(&value, from, sizeof(T));
    return static_cast<double>(value);
}

double loadPcdNumber(const char* from, const PcdField& field)
{
    switch (field.type) {
        case 'F': return field.size == 8 ? loadField<double>(from) : loadField<float>(from);
        case 'I':
            switch (field.size) {
                case 1: return loadField<std::int8_t>(from);
                case 2: return loadField<std::int16_t>(from);
                case 4: return loadField<std::int32_t>(from);
                default: return loadField<std::int64_t>(from);
            }
        default:
            switch (field.size) {
                case 1: return loadField<std::uint8_t>(from);
                case 2: return loadField<std::uint16_t>(from);
                case 4: return loadField<std::uint32_t>(from);
                default: return loadField<std::uint64_t>(from);
            }
    }
}

/// The fields used: x y z and, when complete, the normal.
std::vector<const PcdField*> wantedFields(const PcdHeader& header, std::int64_t line)
{
    std::vector<const PcdField*> fields = {header.find("x"), header.find("y"), header.find("z")};
    const std::array<const PcdField*, 3> normal = {header.find("normal_x"), header.find("normal_y"),
                                                   header.find("normal_z")};
    if (normal[0] && normal[1] && normal[2] && normal[0]->count > 0 && normal[1]->count > 0 && normal[2]->count > 0)
        fields.insert(fields.end(), normal.begin(), normal.end());
    for (const PcdField* field : fields)
        if (field->type == 'F' && field->size < 4)
            throw Error(errors::malformed, {{"line", line},
                                            {"column", std::int64_t{1}},
                                            {"found", field->size},
                                            {"expected", LT_TEXT("Engine", "real numbers of 4 or 8 bytes")}});
    return fields;
}

Error truncatedPoints(Values place, std::int64_t found, std::int64_t expected)
{
    set(place, "found", found);
    set(place, "expected", expected);
    set(place, "items", LT_TEXT("Engine", "points"));
    return Error(errors::truncated, place);
}

/// Fills the scan; address(point, field) is the location of a value.
template <class Address>
void fillScan(Scan& scan, std::size_t points, const std::vector<const PcdField*>& fields, const Progress& progress,
              Address address)
{
    scan.points_mm.resize(points);
    if (fields.size() == 6) scan.normals.resize(points);
    parallelFor(points, pointsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t k = 0; k < fields.size(); ++k) {
                const double value = loadPcdNumber(address(i, *fields[k]), *fields[k]);
                if (k < 3)
                    scan.points_mm[i][static_cast<int>(k)] = value;
                else
                    scan.normals[i][static_cast<int>(k - 3)] = static_cast<float>(value);
            }
    });
}

void readBinary(const ScanSource& source, const PcdHeader& header, RawScan& raw)
{
    const auto available = static_cast<std::int64_t>((source.bytes.size() - header.body_offset) / header.stride);
    if (available < header.points)
        throw truncatedPoints({{"byte", static_cast<std::int64_t>(source.bytes.size())}}, available, header.points);
    refuseMoreBytes(source.bytes, header.body_offset + static_cast<std::size_t>(header.points) * header.stride);
    const char* const data = source.bytes.data() + header.body_offset;
    raw.places = {0, static_cast<std::int64_t>(header.body_offset), static_cast<std::int64_t>(header.stride)};
    fillScan(raw.scan, static_cast<std::size_t>(header.points), wantedFields(header, header.body_line - 1),
             source.progress,
             [&](std::size_t point, const PcdField& field) { return data + point * header.stride + field.offset; });
}

/// Compressed data are stored field by field.
void readCompressed(const ScanSource& source, const PcdHeader& header, RawScan& raw)
{
    const std::string_view body = source.bytes.substr(header.body_offset);
    const Values place{{"byte", static_cast<std::int64_t>(header.body_offset)}};
    std::uint32_t compressed = 0;
    std::uint32_t size = 0;
    if (body.size() < 8) throw truncatedPoints(place, 0, header.points);
    std::memcpy(&compressed, body.data(), 4);
    std::memcpy(&size, body.data() + 4, 4);
    if (body.size() - 8 < compressed)
        throw Error(errors::truncated, {{"byte", static_cast<std::int64_t>(source.bytes.size())},
                                        {"found", static_cast<std::int64_t>(body.size() - 8)},
                                        {"expected", static_cast<std::int64_t>(compressed)},
                                        {"items", LT_TEXT("Engine", "bytes")}});
    refuseMoreBytes(body, std::size_t{8} + compressed);
    const auto available = static_cast<std::int64_t>(size / header.stride);
    if (available < header.points) throw truncatedPoints(place, available, header.points);
    const auto data = decompressLzf(body.substr(8, compressed), size);
    if (!data)
        throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(header.body_offset + 8)},
                                        {"found", LT_TEXT("Engine", "damaged compressed data")},
                                        {"expected", LT_TEXT("Engine", "data in LZF compression")}});
    raw.places = {0, static_cast<std::int64_t>(header.body_offset), 0};
    const auto points = static_cast<std::size_t>(header.points);
    fillScan(raw.scan, points, wantedFields(header, header.body_line - 1), source.progress,
             [&](std::size_t point, const PcdField& field) {
                 return data->data() + field.offset * points +
                        point * static_cast<std::size_t>(field.size * field.count);
             });
}

void readAscii(const ScanSource& source, const PcdHeader& header, RawScan& raw)
{
    const std::vector<const PcdField*> fields = wantedFields(header, header.body_line - 1);
    Lines lines(source.text, header.body_offset, header.body_line);
    NumberCells numbers(source);
    Words words;
    for (std::int64_t i = 0; i < header.points; ++i) {
        if ((i & 0x3FFF) == 0) source.progress.check();
        do {
            if (!lines.next())
                throw truncatedPoints({{"line", lines.number()}, {"column", std::int64_t{1}}}, i, header.points);
            splitWords(lines.line(), words);
        } while (words.empty());
        if (i == 0) raw.places.first_line = lines.number();
        if (words.size() != header.words) {
            const bool more = words.size() > header.words;
            throw malformed(lines.number(), lines.line(),
                            more ? words[header.words] : lines.line().substr(lines.line().size()),
                            more ? LT_TEXT("Engine", "the end of the line") : LT_TEXT("Engine", "a number"));
        }
        const auto value = [&](std::size_t k) {
            return numbers.read(lines.number(), lines.line(), words[fields[k]->word]);
        };
        raw.scan.points_mm.emplace_back(value(0), value(1), value(2));
        if (fields.size() == 6) raw.scan.normals.push_back(Eigen::Vector3d(value(3), value(4), value(5)).cast<float>());
    }
    raw.facts.encoding = source.encoding;
    raw.facts.delimiter = "space";
    raw.facts.decimal = numbers.decimalName();
}

}  // namespace

RawScan readPcd(const ScanSource& source)
{
    const PcdHeader header = readPcdHeader(source.text.empty() ? source.bytes : source.text);
    RawScan raw;
    raw.stated_unit = header.unit;
    raw.facts.columns = static_cast<std::int64_t>(header.words);
    switch (header.data) {
        case PcdData::Ascii:
            raw.facts.format = "pcd_ascii";
            readAscii(source, header, raw);
            break;
        case PcdData::Binary:
            raw.facts.format = "pcd_binary";
            readBinary(source, header, raw);
            break;
        case PcdData::Compressed:
            raw.facts.format = "pcd_binary_compressed";
            readCompressed(source, header, raw);
            break;
    }
    raw.facts.rows = static_cast<std::int64_t>(raw.scan.points_mm.size());
    return raw;
}

}  // namespace lathelier::io
