// The header of a PLY file (G. Turk, The PLY Polygon File Format, 1994).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/io/units.h"

namespace lathelier {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

struct PlyProperty {
    std::string name;  ///< lower case
    PlyType type = PlyType::Float;
    bool isList = false;
    PlyType countType = PlyType::UInt8;  ///< of a list's length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;  ///< as announced
    std::vector<PlyProperty> properties;

    bool hasList() const;
    std::size_t stride() const;                ///< bytes of one element without lists
    int indexOf(std::string_view name) const;  ///< of a property; -1 without it
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::optional<LengthScale> unit;  ///< stated in a comment
    std::size_t bodyOffset = 0;
    std::int64_t bodyLine = 1;
    std::vector<std::int64_t> commentLines;
    bool synthetic = false;  ///< a comment begins with "synthetic", as in the files that Lathelier makes
};

std::size_t sizeOf(PlyType type);

bool startsLikePly(std::string_view bytes);

/// Error malformed (`line`, `column`).
PlyHeader readPlyHeader(std::string_view bytes);

}  // namespace lathelier
