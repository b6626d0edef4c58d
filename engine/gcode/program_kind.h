// NC programs as a kind of file.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::gcode {

/// Programs of the dialects that are read; also of those that are refused by name, so that they are named. facts:
/// format "nc_program", details "dialect", "blocks", "words", "words_understood", "diagnostics" [line, column,
/// severity, code, text, block]. A program with errors has facts all the same.
const io::FileKind& programFiles();

}  // namespace lathelier::gcode
