// PLY files: ascii and binary in both byte orders.
#include "engine/io/cloud/ply_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "engine/core/parallel.h"
#include "engine/io/cloud/mesh_faces.h"
#include "engine/io/cloud/ply_header.h"
#include "engine/io/cloud/raw_scan.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/number_cell.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
T loadValue(const char* from, bool swap)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, from, sizeof(T));
    if (swap) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

double loadPlyNumber(const char* from, PlyType type, bool swap)
{
    switch (type) {
        case PlyType::Int8: return loadValue<std::int8_t>(from, swap);
        case PlyType::UInt8: return loadValue<std::uint8_t>(from, swap);
        case PlyType::Int16: return loadValue<std::int16_t>(from, swap);
        case PlyType::UInt16: return loadValue<std::uint16_t>(from, swap);
        case PlyType::Int32: return loadValue<std::int32_t>(from, swap);
        case PlyType::UInt32: return loadValue<std::uint32_t>(from, swap);
        case PlyType::Float: return static_cast<double>(loadValue<float>(from, swap));
        case PlyType::Double: return loadValue<double>(from, swap);
    }
    return 0;
}

/// Meaning of the vertex properties.
struct VertexColumns {
    std::array<int, 3> point = {-1, -1, -1};
    std::array<int, 3> normal = {-1, -1, -1};
    bool hasNormals() const { return normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0; }
};

VertexColumns findVertexColumns(const PlyElement& vertex, const PlyHeader& header)
{
    VertexColumns columns;
    constexpr std::array<std::array<const char*, 2>, 3> normalNames = {
        {{"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}}};
    constexpr std::array<const char*, 3> pointNames = {"x", "y", "z"};
    const auto find = [&vertex](const char* name) {
        const int index = vertex.indexOf(name);
        return index >= 0 && !vertex.properties[static_cast<std::size_t>(index)].is_list ? index : -1;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        columns.point[k] = find(pointNames[k]);
        columns.normal[k] = std::max(find(normalNames[k][0]), find(normalNames[k][1]));
        if (columns.point[k] < 0)
            throw Error(errors::malformed,
                        {{"line", header.body_line - 1},
                         {"column", std::int64_t{1}},
                         {"found", std::string("end_header")},
                         {"expected", LT_TEXT("Engine", "vertices with the properties x, y and z")}});
    }
    return columns;
}

Error truncatedItems(Values place, std::uint64_t found, std::uint64_t expected, Text items)
{
    set(place, "found", static_cast<std::int64_t>(found));
    set(place, "expected", static_cast<std::int64_t>(expected));
    set(place, "items", items);
    return Error(errors::truncated, place);
}

Text itemsOf(const PlyElement& element)
{
    if (element.name == "vertex") return LT_TEXT("Engine", "vertices");
    if (element.name == "face") return LT_TEXT("Engine", "faces");
    return LT_TEXT("Engine", "elements");
}

int faceListOf(const PlyElement& element)
{
    const int index = std::max(element.indexOf("vertex_indices"), element.indexOf("vertex_index"));
    return index >= 0 && element.properties[static_cast<std::size_t>(index)].is_list ? index : -1;
}

class BinaryBody {
public:
    BinaryBody(const ScanSource& source, const PlyHeader& header, RawScan& raw)
        : bytes_(source.bytes),
          progress_(source.progress),
          swap_(header.format == PlyFormat::BigEndian),
          at_(header.body_offset),
          raw_(raw)
    {
    }

    void readVertices(const PlyElement& vertex, const VertexColumns& columns)
    {
        raw_.places = {0, static_cast<std::int64_t>(at_),
                       vertex.hasList() ? 0 : static_cast<std::int64_t>(vertex.stride())};
        if (vertex.hasList())
            readVerticesWithLists(vertex, columns);
        else
            readEvenVertices(vertex, columns);
    }

    void readFaces(const PlyElement& face, int list)
    {
        std::vector<std::int64_t> corners;
        const PlyType type = face.properties[static_cast<std::size_t>(list)].type;
        for (std::uint64_t i = 0; i < face.count; ++i) {
            if ((i & 0xFFFF) == 0) progress_.check();
            const std::size_t begin = at_;
            corners.clear();
            walk(face, i, [&](std::size_t k, const char* from, std::uint64_t count) {
                if (static_cast<int>(k) != list) return;
                for (std::uint64_t c = 0; c < count; ++c)
                    corners.push_back(static_cast<std::int64_t>(loadPlyNumber(from + c * sizeOf(type), type, swap_)));
            });
            addPolygon(raw_.scan, corners, {{"byte", static_cast<std::int64_t>(begin)}});
        }
    }

    void skip(const PlyElement& element)
    {
        if (!element.hasList()) {
            const std::size_t stride = element.stride();
            const std::uint64_t available = stride == 0 ? element.count : (bytes_.size() - at_) / stride;
            if (available < element.count) throw tooShort(element, available);
            at_ += stride * element.count;
            return;
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if ((i & 0xFFFF) == 0) progress_.check();
            walk(element, i, [](std::size_t, const char*, std::uint64_t) {});
        }
    }

    void finish() const { refuseMoreBytes(bytes_, at_); }

private:
    Error tooShort(const PlyElement& element, std::uint64_t found) const
    {
        return truncatedItems({{"byte", static_cast<std::int64_t>(bytes_.size())}}, found, element.count,
                              itemsOf(element));
    }

    void readEvenVertices(const PlyElement& vertex, const VertexColumns& columns)
    {
        const std::size_t stride = vertex.stride();
        const std::uint64_t available = (bytes_.size() - at_) / stride;
        if (available < vertex.count) throw tooShort(vertex, available);
        const auto count = static_cast<std::size_t>(vertex.count);
        std::vector<std::size_t> offsets;
        for (std::size_t k = 0, offset = 0; k < vertex.properties.size(); ++k) {
            offsets.push_back(offset);
            offset += sizeOf(vertex.properties[k].type);
        }
        Scan& scan = raw_.scan;
        scan.points_mm.resize(count);
        if (columns.hasNormals()) scan.normals.resize(count);
        const char* const data = bytes_.data() + at_;
        const auto property = [&](int k) { return static_cast<std::size_t>(k); };
        const bool plainFloats = !swap_ && std::all_of(columns.point.begin(), columns.point.end(), [&](int k) {
            return vertex.properties[property(k)].type == PlyType::Float;
        });
        parallelFor(count, pointsPerTask, progress_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const char* const from = data + i * stride;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::size_t p = property(columns.point[k]);
                    scan.points_mm[i][static_cast<int>(k)] =
                        plainFloats ? static_cast<double>(loadValue<float>(from + offsets[p], false))
                                    : loadPlyNumber(from + offsets[p], vertex.properties[p].type, swap_);
                }
                if (!columns.hasNormals()) continue;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::size_t p = property(columns.normal[k]);
                    scan.normals[i][static_cast<int>(k)] =
                        static_cast<float>(loadPlyNumber(from + offsets[p], vertex.properties[p].type, swap_));
                }
            }
        });
        at_ += count * stride;
    }

    void readVerticesWithLists(const PlyElement& vertex, const VertexColumns& columns)
    {
        for (std::uint64_t i = 0; i < vertex.count; ++i) {
            if ((i & 0xFFFF) == 0) progress_.check();
            Eigen::Vector3d point = Eigen::Vector3d::Zero();
            Eigen::Vector3f normal = Eigen::Vector3f::Zero();
            walk(vertex, i, [&](std::size_t k, const char* from, std::uint64_t) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    if (columns.point[axis] == static_cast<int>(k))
                        point[static_cast<int>(axis)] = loadPlyNumber(from, vertex.properties[k].type, swap_);
                    if (columns.normal[axis] == static_cast<int>(k))
                        normal[static_cast<int>(axis)] =
                            static_cast<float>(loadPlyNumber(from, vertex.properties[k].type, swap_));
                }
            });
            raw_.scan.points_mm.push_back(point);
            if (columns.hasNormals()) raw_.scan.normals.push_back(normal);
        }
    }

    /// Iterates over one element; visit(property, its first value, number of values).
    template <class Visit>
    void walk(const PlyElement& element, std::uint64_t index, Visit visit)
    {
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            std::uint64_t count = 1;
            if (property.is_list) {
                const std::size_t size = sizeOf(property.count_type);
                if (bytes_.size() - at_ < size) throw tooShort(element, index);
                const double length = loadPlyNumber(bytes_.data() + at_, property.count_type, swap_);
                if (length < 0)
                    throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(at_)},
                                                    {"found", static_cast<std::int64_t>(length)},
                                                    {"expected", LT_TEXT("Engine", "the length of a list")}});
                count = static_cast<std::uint64_t>(length);
                at_ += size;
            }
            const std::size_t size = sizeOf(property.type);
            if ((bytes_.size() - at_) / size < count) throw tooShort(element, index);
            visit(k, bytes_.data() + at_, count);
            at_ += static_cast<std::size_t>(count) * size;
        }
    }

    std::string_view bytes_;
    const Progress& progress_;
    bool swap_;
    std::size_t at_;
    RawScan& raw_;
};

class AsciiBody {
public:
    AsciiBody(const ScanSource& source, const PlyHeader& header, RawScan& raw)
        : lines_(source.text, header.body_offset, header.body_line),
          number_(source),
          progress_(source.progress),
          raw_(raw)
    {
    }

    void readVertices(const PlyElement& vertex, const VertexColumns& columns)
    {
        std::vector<double> values(vertex.properties.size());
        for (std::uint64_t i = 0; i < vertex.count; ++i) {
            nextElement(vertex, i);
            if (i == 0) raw_.places.first_line = lines_.number();
            readValues(vertex, [&](std::size_t k, double value, std::size_t) { values[k] = value; });
            const auto value = [&values](int k) { return values[static_cast<std::size_t>(k)]; };
            raw_.scan.points_mm.emplace_back(value(columns.point[0]), value(columns.point[1]), value(columns.point[2]));
            if (columns.hasNormals())
                raw_.scan.normals.push_back(
                    Eigen::Vector3d(value(columns.normal[0]), value(columns.normal[1]), value(columns.normal[2]))
                        .cast<float>());
        }
    }

    void readFaces(const PlyElement& face, int list)
    {
        std::vector<std::int64_t> corners;
        for (std::uint64_t i = 0; i < face.count; ++i) {
            nextElement(face, i);
            corners.clear();
            readValues(face, [&](std::size_t k, double value, std::size_t) {
                if (static_cast<int>(k) == list) corners.push_back(indexFrom(value));
            });
            addPolygon(raw_.scan, corners, {{"line", lines_.number()}, {"column", std::int64_t{1}}});
        }
    }

    void skip(const PlyElement& element)
    {
        for (std::uint64_t i = 0; i < element.count; ++i) nextElement(element, i);
    }

    std::string decimalName() const { return number_.decimalName(); }

private:
    static std::int64_t indexFrom(double value)
    {
        return std::abs(value) < 1e15 && value == std::floor(value) ? static_cast<std::int64_t>(value) : -1;
    }

    /// Goes to the next line that is not blank and splits it.
    void nextElement(const PlyElement& element, std::uint64_t index)
    {
        if ((index & 0x3FFF) == 0) progress_.check();
        do {
            if (!lines_.next())
                throw truncatedItems({{"line", lines_.number()}, {"column", std::int64_t{1}}}, index, element.count,
                                     itemsOf(element));
            splitWords(lines_.line(), words_);
        } while (words_.empty());
    }

    template <class Store>
    void readValues(const PlyElement& element, Store store)
    {
        std::size_t word = 0;
        const auto next = [&] {
            if (word == words_.size())
                throw malformed(lines_.number(), lines_.line(), lines_.line().substr(lines_.line().size()),
                                LT_TEXT("Engine", "a number"));
            return number_.read(lines_.number(), lines_.line(), words_[word++]);
        };
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            if (!element.properties[k].is_list) {
                store(k, next(), std::size_t{0});
                continue;
            }
            const double length = next();
            if (!(length >= 0 && length <= static_cast<double>(words_.size())))
                throw malformed(lines_.number(), lines_.line(), words_[word - 1],
                                LT_TEXT("Engine", "the length of a list"));
            for (std::size_t c = 0; c < static_cast<std::size_t>(length); ++c) store(k, next(), c);
        }
        if (word != words_.size())
            throw malformed(lines_.number(), lines_.line(), words_[word], LT_TEXT("Engine", "the end of the line"));
    }

    Lines lines_;
    NumberCells number_;
    const Progress& progress_;
    RawScan& raw_;
    std::vector<std::string_view> words_;
};

template <class Body>
void readBody(Body& body, const PlyHeader& header)
{
    bool vertices = false;
    for (const PlyElement& element : header.elements) {
        const int list = faceListOf(element);
        if (element.name == "vertex" && !vertices) {
            body.readVertices(element, findVertexColumns(element, header));
            vertices = true;
        } else if (element.name == "face" && vertices && list >= 0) {
            body.readFaces(element, list);
        } else {
            body.skip(element);
        }
    }
}

}  // namespace

RawScan readPly(const ScanSource& source)
{
    const bool isText = !source.text.empty();
    const PlyHeader header = readPlyHeader(isText ? source.text : source.bytes);
    const auto vertex = std::find_if(header.elements.begin(), header.elements.end(),
                                     [](const PlyElement& e) { return e.name == "vertex"; });
    if (vertex == header.elements.end())
        throw Error(errors::malformed, {{"line", header.body_line - 1},
                                        {"column", std::int64_t{1}},
                                        {"found", std::string("end_header")},
                                        {"expected", LT_TEXT("Engine", "an element vertex")}});
    RawScan raw;
    raw.stated_unit = header.unit;
    if (header.synthetic) raw.notes.push_back({notes::syntheticData, {}});
    raw.facts.columns = static_cast<std::int64_t>(vertex->properties.size());
    if (header.format == PlyFormat::Ascii) {
        AsciiBody body(source, header, raw);
        readBody(body, header);
        raw.facts.format = "ply_ascii";
        raw.facts.encoding = source.encoding;
        raw.facts.delimiter = "space";
        raw.facts.decimal = body.decimalName();
    } else {
        BinaryBody body(source, header, raw);
        readBody(body, header);
        body.finish();
        raw.facts.format = header.format == PlyFormat::BigEndian ? "ply_binary_big_endian" : "ply_binary_little_endian";
    }
    raw.facts.rows = static_cast<std::int64_t>(raw.scan.points_mm.size());
    return raw;
}

}  // namespace lathelier::io
