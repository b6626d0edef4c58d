#include "engine/io/frf/mat_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "engine/core/error.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {
namespace {

constexpr std::size_t matHeadBytes = 128;
constexpr std::size_t largestVariable = std::size_t{1} << 28;  ///< bytes after inflation
constexpr std::size_t nameAndShape = 1 << 14;  ///< bytes at the start of a variable that contain its name and shape
constexpr std::uint32_t miMatrix = 14, miCompressed = 15;
constexpr std::string_view classNames[] = {"unknown", "cell",   "struct", "object", "char",  "sparse",
                                           "double",  "single", "int8",   "uint8",  "int16", "uint16",
                                           "int32",   "uint32", "int64",  "uint64"};
constexpr std::uint32_t firstNumberClass = 6;
constexpr std::uint32_t complexFlag = 0x800;
constexpr std::int64_t largestDimension = std::numeric_limits<std::int32_t>::max();

Error wrongAt(std::size_t byte, Value found, Text expected)
{
    return Error(errors::malformed,
                 {{"byte", static_cast<std::int64_t>(byte)}, {"found", std::move(found)}, {"expected", expected}});
}

Error endsAt(std::size_t byte, std::size_t found, std::uint64_t expected)
{
    return Error(errors::truncated, {{"byte", static_cast<std::int64_t>(byte)},
                                     {"found", static_cast<std::int64_t>(found)},
                                     {"expected", static_cast<std::int64_t>(expected)},
                                     {"items", LT_TEXT("Engine", "bytes of a variable")}});
}

bool isSwapped(std::string_view file)
{
    return (file[126] == 'M') != (std::endian::native == std::endian::big);
}

template <class T>
T matValueAt(std::string_view bytes, std::size_t at, bool swapped)
{
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes.data() + at, raw.size());
    if (swapped) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
}

/// A data element and the offset of the next one.
struct Element {
    std::uint32_t type = 0;
    std::string_view data;
    std::size_t size = 0;  ///< stated size; `data` may be truncated
    std::size_t next = 0;
};

/// Elements one after the other; offsets in errors refer to the file.
class Elements {
public:
    /// `byte`: offset of the outermost element in the file. `partly`: data may be truncated.
    Elements(std::string_view bytes, bool swapped, std::size_t byte, bool partly)
        : bytes_(bytes), swapped_(swapped), byte_(byte), partly_(partly)
    {
    }

    Element at(std::size_t offset) const
    {
        if (offset > bytes_.size() || bytes_.size() - offset < 8) throw endsAt(byte_, bytes_.size(), offset + 8);
        const auto word = matValueAt<std::uint32_t>(bytes_, offset, swapped_);
        Element element;
        if ((word >> 16) != 0) {  // small: type and size in one word
            element.type = word & 0xFFFFU;
            element.size = word >> 16;
            if (element.size > 4) throw wrongAt(byte_, std::int64_t{word}, LT_TEXT("Engine", "a small data element"));
            element.data = bytes_.substr(offset + 4, element.size);
            element.next = offset + 8;
            return element;
        }
        element.type = word;
        element.size = matValueAt<std::uint32_t>(bytes_, offset + 4, swapped_);
        const std::size_t there = bytes_.size() - offset - 8;
        if (element.size > there && !partly_) throw endsAt(byte_, there, element.size);
        element.data = bytes_.substr(offset + 8, std::min(element.size, there));
        const std::size_t padding = element.type == miCompressed ? 0 : (8 - element.size % 8) % 8;
        element.next = offset + 8 + element.size + padding;
        return element;
    }

    bool swapped() const { return swapped_; }
    std::size_t byte() const { return byte_; }

private:
    std::string_view bytes_;
    bool swapped_;
    std::size_t byte_;
    bool partly_;
};

/// Inflates up to `most` bytes; memory grows with the output.
std::string inflated(std::string_view data, std::size_t most, std::size_t byte)
{
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) throw wrongAt(byte, std::string("zlib"), LT_TEXT("Engine", "memory for zlib"));
    const struct Closer {
        z_stream* stream;
        ~Closer() { inflateEnd(stream); }
    } closer{&stream};
    std::array<char, 1 << 14> step{};
    std::string result;
    std::string input(data.substr(0, std::min<std::size_t>(data.size(), std::numeric_limits<uInt>::max())));
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    int state = Z_OK;
    while (state == Z_OK && result.size() < most) {
        stream.next_out = reinterpret_cast<Bytef*>(step.data());
        stream.avail_out = static_cast<uInt>(std::min(step.size(), most - result.size()));
        const uInt wanted = stream.avail_out;
        state = inflate(&stream, Z_NO_FLUSH);
        result.append(step.data(), wanted - stream.avail_out);
        if (wanted == stream.avail_out) break;  // end of input
    }
    if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
        throw wrongAt(byte, std::string("zlib"), LT_TEXT("Engine", "data compressed by zlib"));
    return result;
}

/// Header of a matrix.
struct MatrixHead {
    MatVariable variable;
    std::size_t numbers = 0;  ///< offset of the real parts within the matrix
};

MatrixHead readHead(const Elements& elements)
{
    constexpr Text expected = LT_TEXT("Engine", "flags, dimensions and the name of a variable");
    const Element flags = elements.at(0);
    if (flags.data.size() < 8) throw wrongAt(elements.byte(), static_cast<std::int64_t>(flags.size), expected);
    const auto word = matValueAt<std::uint32_t>(flags.data, 0, elements.swapped());
    const Element shape = elements.at(flags.next);
    if (shape.data.size() != shape.size || shape.size < 8 || shape.size % 4 != 0)
        throw wrongAt(elements.byte(), static_cast<std::int64_t>(shape.size), expected);
    MatrixHead head;
    head.variable.columns = 1;
    for (std::size_t k = 0; k < shape.size; k += 4) {
        const std::int64_t dimension = matValueAt<std::int32_t>(shape.data, k, elements.swapped());
        std::int64_t& side = k == 0 ? head.variable.rows : head.variable.columns;
        if (dimension < 0) throw wrongAt(elements.byte(), dimension, expected);
        side = k == 0 ? dimension : side * dimension;
        if (side > largestDimension) throw wrongAt(elements.byte(), side, expected);
    }
    const Element name = elements.at(shape.next);
    if (name.data.size() != name.size) throw wrongAt(elements.byte(), static_cast<std::int64_t>(name.size), expected);
    const DecodedText written = decodeText(name.data, Encoding::Latin1);
    for (const char c : written.view())
        if (static_cast<unsigned char>(c) >= 0x20) head.variable.name += c;
    const std::uint32_t kind = word & 0xFFU;
    head.variable.class_name = classNames[kind < std::size(classNames) ? kind : 0];
    head.variable.is_complex = (word & complexFlag) != 0;
    head.variable.is_number = kind >= firstNumberClass && kind < std::size(classNames);
    head.numbers = name.next;
    return head;
}

template <class T>
void convert(const Element& element, bool swapped, std::vector<double>& values)
{
    for (std::size_t at = 0; at + sizeof(T) <= element.data.size(); at += sizeof(T))
        values.push_back(static_cast<double>(matValueAt<T>(element.data, at, swapped)));
}

/// The numbers of an element of any storage type.
std::vector<double> numbersOf(const Element& element, const Elements& elements)
{
    std::vector<double> values;
    const bool swapped = elements.swapped();
    switch (element.type) {
        case 1: convert<std::int8_t>(element, swapped, values); break;
        case 2: convert<std::uint8_t>(element, swapped, values); break;
        case 3: convert<std::int16_t>(element, swapped, values); break;
        case 4: convert<std::uint16_t>(element, swapped, values); break;
        case 5: convert<std::int32_t>(element, swapped, values); break;
        case 6: convert<std::uint32_t>(element, swapped, values); break;
        case 7: convert<float>(element, swapped, values); break;
        case 9: convert<double>(element, swapped, values); break;
        case 12: convert<std::int64_t>(element, swapped, values); break;
        case 13: convert<std::uint64_t>(element, swapped, values); break;
        default: throw wrongAt(elements.byte(), std::int64_t{element.type}, LT_TEXT("Engine", "a type of numbers"));
    }
    return values;
}

/// The matrix inside a compressed element, limited to `most` bytes.
struct Inflated {
    std::string bytes;     ///< content including the tag of the matrix
    std::size_t size = 0;  ///< size stated in the tag of the matrix
};

Inflated inflateMatrix(const Element& element, bool swapped, std::size_t byte, std::size_t most)
{
    Inflated matrix{inflated(element.data, most, byte), 0};
    if (matrix.bytes.size() < 8) throw endsAt(byte, matrix.bytes.size(), 8);
    if (matValueAt<std::uint32_t>(matrix.bytes, 0, swapped) != miMatrix)
        throw wrongAt(byte, std::string("?"), LT_TEXT("Engine", "a matrix"));
    matrix.size = matValueAt<std::uint32_t>(matrix.bytes, 4, swapped);
    matrix.bytes.erase(0, 8);
    if (matrix.bytes.size() > matrix.size) matrix.bytes.resize(matrix.size);
    return matrix;
}

void requireLevel5(std::string_view bytes)
{
    constexpr Text expected = LT_TEXT("Engine", "a MAT file of level 5 (MATLAB 5 to 7)");
    const auto refuse = [expected](Text found) {
        return Error(errors::formatUnknown, {{"byte", std::int64_t{0}}, {"found", found}, {"expected", expected}});
    };
    if (!isMat(bytes)) throw refuse(LT_TEXT("Engine", "something else"));
    if (matValueAt<std::uint16_t>(bytes, 124, isSwapped(bytes)) != 0x0100)
        throw refuse(LT_TEXT("Engine", "a MAT file 7.3 (HDF5); save it with -v7"));
}

}  // namespace

bool isMat(std::string_view head)
{
    if (head.size() < matHeadBytes || !head.starts_with("MATLAB ")) return false;
    const std::string_view order = head.substr(126, 2);
    return order == "IM" || order == "MI";
}

std::vector<MatVariable> readMatVariables(std::string_view bytes, const Progress& progress)
{
    requireLevel5(bytes);
    const bool swapped = isSwapped(bytes);
    std::vector<MatVariable> variables;
    for (std::size_t offset = matHeadBytes; bytes.size() - std::min(bytes.size(), offset) >= 8;) {
        progress.report(static_cast<double>(offset) / static_cast<double>(bytes.size()));
        const Element element = Elements(bytes, swapped, offset, false).at(offset);
        std::string head;
        std::string_view matrix;
        if (element.type == miCompressed) {
            head = inflateMatrix(element, swapped, offset, nameAndShape).bytes;
            matrix = head;
        } else if (element.type == miMatrix) {
            matrix = element.data;
        }
        if (!matrix.empty()) {
            variables.push_back(readHead(Elements(matrix, swapped, offset, true)).variable);
            variables.back().byte = static_cast<std::int64_t>(offset);
        }
        offset = element.next;
    }
    return variables;
}

std::vector<std::complex<double>> readMatValues(std::string_view bytes, const MatVariable& variable)
{
    const bool swapped = isSwapped(bytes);
    const auto byte = static_cast<std::size_t>(variable.byte);
    const Element element = Elements(bytes, swapped, byte, false).at(byte);
    std::string storage;
    std::string_view matrix = element.data;
    if (element.type == miCompressed) {
        Inflated whole = inflateMatrix(element, swapped, byte, largestVariable);
        if (whole.bytes.size() < whole.size) throw endsAt(byte, whole.bytes.size(), whole.size);
        storage = std::move(whole.bytes);
        matrix = storage;
    }
    const Elements elements(matrix, swapped, byte, false);
    const MatrixHead head = readHead(elements);
    const Element real = elements.at(head.numbers);
    const auto count = static_cast<std::uint64_t>(variable.count());
    const std::vector<double> re = numbersOf(real, elements);
    std::vector<double> im;
    if (variable.is_complex) im = numbersOf(elements.at(real.next), elements);
    if (re.size() != count) throw endsAt(byte, re.size(), count);
    if (variable.is_complex && im.size() != count) throw endsAt(byte, im.size(), count);
    std::vector<std::complex<double>> values(re.size());
    for (std::size_t i = 0; i < re.size(); ++i) values[i] = {re[i], im.empty() ? 0 : im[i]};
    return values;
}

}  // namespace lathelier::io
