// Reading point clouds and meshes.
#pragma once

#include <string>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/io/import.h"

namespace lathelier::io {

/// A scan in mm with the facts of its file.
struct ScanFile {
    Scan scan;        ///< scan in mm
    FileFacts facts;  ///< details: "points", "triangles", "min_mm", "max_mm" (see toJson)
    Notes notes;      ///< assumptions and omissions of the reader
};

/// Reads XYZ/ASC/CSV/TXT/PTS, PLY (ascii, binary little and big endian), PCD (ascii, binary), STL (ascii, binary,
/// several solids) and OBJ; selected by content, or by the file's extension where the content is not distinctive. Full
/// double precision is kept, the result does not depend on the locale, and equal STL corners become one vertex. Unit: a
/// stated one has precedence, then `options.unit`, else a largest extent of 1 to 10 000 is read as mm with the note
/// unitGuessed, else Error unitUnknown. Errors (all with `path`, and `line` + `column` or `byte`): fileNotFound,
/// fileNotReadable, notAFile, fileEmpty, formatUnknown, malformed, columnsAmbiguous, truncated, numberAmbiguous,
/// unitUnknown, noPoints, coordinateTooLarge. Throws Cancelled. Memory grows with the data found, not with the sizes
/// stated in a header.
ScanFile readScan(const std::string& path, const ImportOptions& options = {}, const Progress& progress = {});

/// The same from memory; `name` replaces the path in messages.
ScanFile readScan(const std::string& name, std::string_view bytes, const ImportOptions& options,
                  const Progress& progress = {});

/// True when the content is of a format specific to scans: PLY, PCD, STL or OBJ.
bool hasScanFormat(std::string_view bytes);

}  // namespace lathelier::io
