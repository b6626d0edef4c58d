// Common to all readers: import options and the facts found about a file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/understanding.h"

namespace lathelier::io {

enum class Decimal { Auto, Point, Comma };
enum class Delimiter { Auto, Space, Comma, Semicolon, Tab, Pipe };
enum class Encoding { Auto, Utf8, Utf16le, Utf16be, Latin1 };
enum class LengthUnit { Auto, Millimetre, Metre, Inch, Micrometre };

/// Properties that a text file may not state. Auto: determined from the file, rejected when ambiguous with an effect on
/// the numbers.
struct ImportOptions {
    Decimal decimal = Decimal::Auto;        ///< decimal mark of the numbers
    Delimiter delimiter = Delimiter::Auto;  ///< separator of the cells
    Encoding encoding = Encoding::Auto;     ///< character encoding of a text
    LengthUnit unit = LengthUnit::Auto;     ///< unit of lengths without a stated one
};

const std::vector<Field<ImportOptions>>& fieldsOf(const ImportOptions*);

/// A skipped row. `line` counts from 1; in a binary file it is the number of the point.
struct SkippedRow {
    std::int64_t line = 0;  ///< line number, from 1
    Text reason;            ///< reason
};

/// Facts of a file, shown by the command `inspect` and in the import line of the panels. Inapplicable entries (the
/// delimiter of a binary file) are empty or 0, null in JSON.
struct FileFacts {
    std::string path;                 ///< as given to the reader
    std::string format;               ///< "ply_binary_little_endian", "xyz_text", "stl_ascii", "pcd_binary", "obj"…
    std::string encoding;             ///< "utf-8", "utf-16le", "latin-1"…
    std::string delimiter;            ///< "comma", "space"…
    std::string decimal;              ///< "point", "comma"
    std::string unit;                 ///< "mm", "m", "inch", "um"
    std::string unit_source;          ///< "stated", "guessed", "given"
    std::int64_t rows = 0;            ///< rows read; for a cloud its points
    std::int64_t columns = 0;         ///< values in a row of a table, in a vertex, in a frame of a recorder
    std::vector<SkippedRow> skipped;  ///< the first 100; `details` has "skipped_rows" when there are more
    Values details;                   ///< by kind of file: "points", "triangles"…
    std::optional<std::array<double, 3>> min_mm;  ///< smallest coordinates of a cloud or mesh
    std::optional<std::array<double, 3>> max_mm;  ///< largest coordinates
    Understanding understanding;                  ///< of a program: what is not modelled and what is assumed
};

}  // namespace lathelier::io
