// Files of shafts as a kind of file.
#pragma once

#include "engine/io/file_kind.h"
#include "engine/shaft/shaft.h"

namespace lathelier::io {

/// A shaft with the facts of its file.
struct ShaftFile {
    Shaft shaft;
    FileFacts facts;  ///< see shaftFiles()
    Notes notes;      ///< notes of the reader, with the path
};

/// Errors of readShaftFile(), with the path.
ShaftFile loadShaft(const FileToRead& file);

/// SHAFT.json and the stock text. facts: format "shaft_json" | "stock"; details "name", "segments", "length_mm",
/// "largest_diameter_mm", "material" (what the file states).
const FileKind& shaftFiles();

}  // namespace lathelier::io
