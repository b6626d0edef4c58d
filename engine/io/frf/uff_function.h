// Data sets 58 and 58b of a universal file: eleven lines of header, then values.
#pragma once

#include <string_view>

#include "engine/core/progress.h"
#include "engine/io/frf/uff.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {

/// Declaration of binary values in the line of a set's number (columns 7 to 43).
struct UffBinary {
    bool is_big_endian = false;     ///< byte order: file code 1 little, 2 big
    std::int64_t header_lines = 0;  ///< lines of text in front of the values
    std::int64_t bytes = 0;         ///< size of the values
};

/// Parses that line. Error malformed.
UffBinary readUffBinary(const Lines& lines);

/// The bytes declared by `binary` from `offset` on. Error truncated (`byte`).
std::string_view uffPayload(std::string_view file, std::size_t offset, const UffBinary& binary);

/// Reads a set 58 as text: `lines` starts at its number and ends at its last line of values. Errors malformed,
/// uffPointsMissing.
UffFunction readUffText(Lines& lines, const Progress& progress);

/// Reads a set 58b: `lines` ends at the last line of the header, after which the values begin. An uneven abscissa is
/// real*4, also beside double ordinates (12 or 20 bytes a point); real*8 where only that matches the stated bytes.
/// Errors malformed, truncated.
UffFunction readUffBinary(Lines& lines, std::string_view file, const UffBinary& binary);

}  // namespace lathelier::io
