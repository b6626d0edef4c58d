// The header of a PLY file (G. Turk, The PLY Polygon File Format, 1994).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/io/text/units.h"

namespace lathelier::io {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

struct PlyProperty {
    std::string name;                     ///< name in lower case
    PlyType type = PlyType::Float;        ///< of the value, or of a list's items
    bool is_list = false;                 ///< list property: count and items
    PlyType count_type = PlyType::UInt8;  ///< type of a list's count
};

struct PlyElement {
    std::string name;                     ///< as written: "vertex", "face"…
    std::uint64_t count = 0;              ///< number of elements declared
    std::vector<PlyProperty> properties;  ///< in the order of the file

    bool hasList() const;
    std::size_t stride() const;                ///< bytes of one element without lists
    int indexOf(std::string_view name) const;  ///< index of a property; -1: none
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;      ///< encoding of the body
    std::vector<PlyElement> elements;         ///< in the order of the file
    std::optional<LengthScale> unit;          ///< stated in a comment
    std::size_t body_offset = 0;              ///< byte at which the body begins
    std::int64_t body_line = 1;               ///< line at which the body begins, from 1
    std::vector<std::int64_t> comment_lines;  ///< numbers of the lines with comments, from 1
    bool synthetic = false;  ///< a comment begins with "synthetic", as in the files that Lathelier makes
};

std::size_t sizeOf(PlyType type);

bool startsLikePly(std::string_view bytes);

/// Error malformed (`line`, `column`).
PlyHeader readPlyHeader(std::string_view bytes);

}  // namespace lathelier::io
