#include "engine/io/frf/uff_function.h"

#include <bit>
#include <climits>
#include <cmath>
#include <cstring>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/uff_fields.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

using enum UffColumn::Kind;

constexpr UffColumn binaryColumns[] = {{6, Integer}, {1, Word},     {6, Integer},
                                       {6, Integer}, {12, Integer}, {12, Integer}};
constexpr UffColumn nodeColumns[] = {{5, Integer}, {10, Integer}, {5, Integer},  {10, Integer},
                                     {1, Blank},   {10, Word},    {10, Integer}, {4, Integer},
                                     {1, Blank},   {10, Word},    {10, Integer}, {4, Integer}};
constexpr UffColumn formColumns[] = {{10, Integer}, {10, Integer}, {10, Integer}, {13, Real}, {13, Real}, {13, Real}};
constexpr UffColumn axisColumns[] = {{10, Integer}, {5, Integer}, {5, Integer}, {5, Integer},
                                     {1, Blank},    {20, Word},   {1, Blank},   {20, Word}};
constexpr std::int64_t headerLines = 11;
constexpr std::int64_t progressStep = 1 << 16;

/// A header with the declaration of the values.
struct Header {
    UffFunction function;     ///< header data, without values
    std::int64_t points = 0;  ///< number of points declared
    std::int64_t line = 0;    ///< line of the declaration
    double start = 0;         ///< first value of an even abscissa
    double step = 0;          ///< step of an even abscissa
};

void nextHeaderLine(Lines& lines)
{
    constexpr Text expected = LT_TEXT("Engine", "the header of a function");
    if (!lines.next()) throw malformedEnd(lines, expected);
    if (isUffSeparator(lines.line())) throw malformed(lines.number(), lines.line(), lines.line(), expected);
}

void readNodes(const Lines& lines, UffFunction& function)
{
    const UffFields fields(lines.number(), lines.line(), nodeColumns);
    for (const std::size_t k : {6U, 10U})
        if (std::abs(fields.integer(k)) > INT_MAX) throw fields.wrong(k, LT_TEXT("Engine", "the number of a node"));
    function.function = fields.integer(0);
    function.response_entity = fields.text(5);
    function.response_node = fields.integer(6);
    function.response_direction = fields.integer(7);
    function.reference_entity = fields.text(9);
    function.reference_node = fields.integer(10);
    function.reference_direction = fields.integer(11);
}

void readForm(const Lines& lines, Header& header)
{
    const UffFields fields(lines.number(), lines.line(), formColumns);
    const std::int64_t type = fields.integer(0);
    if (type != 2 && type != 4 && type != 5 && type != 6)
        throw fields.wrong(0, LT_TEXT("Engine", "2, 4, 5 or 6 for the type of the values"));
    if (fields.integer(1) < 0) throw fields.wrong(1, LT_TEXT("Engine", "a number of points"));
    if (fields.integer(2) != 0 && fields.integer(2) != 1)
        throw fields.wrong(2, LT_TEXT("Engine", "0 (uneven) or 1 (even)"));
    header.function.data_type = static_cast<int>(type);
    header.points = fields.integer(1);
    header.function.is_even = fields.integer(2) == 1;
    header.start = fields.number(3);
    header.step = fields.number(4);
    header.line = lines.number();
}

UffAxis readAxis(const Lines& lines)
{
    const UffFields fields(lines.number(), lines.line(), axisColumns);
    return {fields.integer(0), fields.text(5),  fields.text(7),
            lines.number(),    fields.begin(7), static_cast<std::int64_t>(lines.offset())};
}

Header readUffHeader(Lines& lines)
{
    Header header;
    for (std::string& id : header.function.id) {
        nextHeaderLine(lines);
        id = std::string(trimmed(uffText(lines.line())));
    }
    nextHeaderLine(lines);
    readNodes(lines, header.function);
    nextHeaderLine(lines);
    readForm(lines, header);
    nextHeaderLine(lines);
    header.function.abscissa = readAxis(lines);
    nextHeaderLine(lines);
    header.function.ordinate = readAxis(lines);
    nextHeaderLine(lines);
    header.function.denominator = readAxis(lines);
    nextHeaderLine(lines);
    readAxis(lines);  // third axis of a spectral map, unused
    return header;
}

/// Widths of the columns of a line of values.
std::vector<int> widthsOf(const UffFunction& function)
{
    const bool isDouble = function.data_type == 4 || function.data_type == 6;
    if (!isDouble) return {13, 13, 13, 13, 13, 13};
    if (function.is_even) return {20, 20, 20, 20};
    if (function.isComplex()) return {13, 20, 20};
    return {13, 20, 13, 20};
}

/// Numbers in a point.
std::size_t numbersPerPoint(const UffFunction& function)
{
    return (function.is_even ? 0U : 1U) + (function.isComplex() ? 2U : 1U);
}

/// Distributes the numbers of all points to abscissa and ordinate.
void layPoints(const Header& header, const std::vector<double>& numbers, UffFunction& function)
{
    const auto points = static_cast<std::size_t>(header.points);
    const std::size_t stride = numbersPerPoint(function), first = function.is_even ? 0 : 1;
    function.x.resize(points);
    function.y.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
        const double* point = numbers.data() + i * stride;
        function.x[i] = function.is_even ? header.start + static_cast<double>(i) * header.step : point[0];
        function.y[i] = {point[first], function.isComplex() ? point[first + 1] : 0};
    }
}

template <class T>
double uffValueAt(const char* at, bool isBigEndian)
{
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), at, bytes.size());
    if (isBigEndian != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<T>(bytes));
}

Error payloadTooShort(std::size_t offset, std::size_t found, std::size_t expected)
{
    return Error(errors::truncated, {{"byte", static_cast<std::int64_t>(offset)},
                                     {"found", static_cast<std::int64_t>(found)},
                                     {"expected", static_cast<std::int64_t>(expected)},
                                     {"items", LT_TEXT("Engine", "bytes of a function's values")}});
}

}  // namespace

UffBinary readUffBinary(const Lines& lines)
{
    const UffFields fields(lines.number(), lines.line(), binaryColumns);
    if (fields.integer(2) != 1 && fields.integer(2) != 2)
        throw fields.wrong(2, LT_TEXT("Engine", "1 (little endian) or 2 (big endian)"));
    if (fields.integer(3) != 2) throw fields.wrong(3, LT_TEXT("Engine", "2 (IEEE 754 numbers)"));
    if (fields.integer(4) < 0 || fields.integer(4) > 1000)
        throw fields.wrong(4, LT_TEXT("Engine", "a number of header lines, 11"));
    if (fields.integer(5) < 0) throw fields.wrong(5, LT_TEXT("Engine", "a number of bytes"));
    return {fields.integer(2) == 2, fields.integer(4), fields.integer(5)};
}

std::string_view uffPayload(std::string_view file, std::size_t offset, const UffBinary& binary)
{
    const std::size_t there = file.size() - std::min(file.size(), offset);
    const auto stated = static_cast<std::size_t>(binary.bytes);
    if (stated > there) throw payloadTooShort(file.size(), there, stated);
    return file.substr(offset, stated);
}

UffFunction readUffText(Lines& lines, const Progress& progress)
{
    Header header = readUffHeader(lines);
    const std::size_t stride = numbersPerPoint(header.function);
    const auto needed = static_cast<std::size_t>(header.points) * stride;
    const std::vector<int> widths = widthsOf(header.function);
    std::vector<double> numbers;
    for (std::int64_t read = 0; numbers.size() < needed; ++read) {
        if (read % progressStep == 0) progress.check();
        Lines ahead = lines;
        if (!ahead.next() || isUffSeparator(ahead.line()))
            throw Error(errors::uffPointsMissing, {{"line", lines.number()},
                                                   {"column", std::int64_t{1}},
                                                   {"found", static_cast<std::int64_t>(numbers.size() / stride)},
                                                   {"expected", header.points},
                                                   {"declared_line", header.line}});
        lines = ahead;
        readUffNumbers(lines.number(), lines.line(), widths, numbers);
    }
    layPoints(header, numbers, header.function);
    return std::move(header.function);
}

UffFunction readUffBinary(Lines& lines, std::string_view file, const UffBinary& binary)
{
    Header header = readUffHeader(lines);
    for (std::int64_t k = headerLines; k < binary.header_lines; ++k)
        if (!lines.next()) throw malformedEnd(lines, LT_TEXT("Engine", "the header of a function"));
    const std::string_view payload = uffPayload(file, lines.nextOffset(), binary);
    UffFunction& function = header.function;
    const bool isDouble = function.data_type == 4 || function.data_type == 6;
    const std::size_t ordinate = std::size_t{isDouble ? 8U : 4U} * (function.isComplex() ? 2U : 1U);
    const auto points = static_cast<std::size_t>(header.points);
    std::size_t abscissa = function.is_even ? 0 : 4;
    const bool onlyWideFits =
        payload.size() != points * (abscissa + ordinate) && payload.size() == points * (8 + ordinate);
    if (abscissa != 0 && isDouble && onlyWideFits) abscissa = 8;
    const std::size_t needed = points * (abscissa + ordinate);
    if (payload.size() < needed) throw payloadTooShort(lines.nextOffset(), payload.size(), needed);
    std::vector<double> numbers;
    numbers.reserve(points * numbersPerPoint(function));
    const bool big = binary.is_big_endian;
    for (const char* at = payload.data(); at != payload.data() + needed;) {
        if (abscissa != 0) numbers.push_back(abscissa == 8 ? uffValueAt<double>(at, big) : uffValueAt<float>(at, big));
        at += abscissa;
        for (const char* end = at + ordinate; at != end; at += isDouble ? 8 : 4)
            numbers.push_back(isDouble ? uffValueAt<double>(at, big) : uffValueAt<float>(at, big));
    }
    layPoints(header, numbers, function);
    return std::move(header.function);
}

}  // namespace lathelier::io
