// Reading point clouds and meshes.
#pragma once

#include <string>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/io/import.h"

namespace lathelier::io {

/// A scan as read, in mm, with what was understood of its file.
struct ScanFile {
    Scan scan;        ///< in mm
    FileFacts facts;  ///< details: "points", "triangles", "min_mm", "max_mm" (see toJson)
    Notes notes;      ///< what the reader had to assume or leave out
};

/// Reads XYZ/ASC/CSV/TXT/PTS, PLY (ascii, binary little and big endian), PCD (ascii, binary), STL (ascii, binary,
/// several solids) and OBJ; the content decides, and the file's extension where the content is of no format of its own.
/// Full double precision is kept, the result does not depend on the locale, and equal STL corners become one vertex.
/// Unit: a stated one rules, else `options.unit`, else a largest extent of 1 to 10 000 is read as mm with the note
/// unitGuessed, else Error unitUnknown.
/// Errors (all with `path`, and `line` + `column` or `byte`): fileNotFound, fileNotReadable, notAFile, fileEmpty,
/// formatUnknown, malformed, columnsAmbiguous, truncated, numberAmbiguous, unitUnknown, noPoints, coordinateTooLarge.
/// Throws Cancelled. Memory is taken as data are found, never because a header promises them.
ScanFile readScan(const std::string& path, const ImportOptions& options = {}, const Progress& progress = {});

/// The same from memory; `name` stands for the path in messages.
ScanFile readScan(const std::string& name, std::string_view bytes, const ImportOptions& options,
                  const Progress& progress = {});

/// True when the content is of a format that only scans have: PLY, PCD, STL or OBJ. Text tables may hold anything.
bool hasScanFormat(std::string_view bytes);

}  // namespace lathelier::io
