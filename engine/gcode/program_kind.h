// NC programs as a kind of file.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::gcode {

/// Programs of the controls that are read; also of those that are named in the error. facts: format
/// "nc_program", details "dialect", "blocks", "words", "words_understood", "diagnostics" [line, column, severity, code,
/// text, block]. Programs with errors have facts as well.
const io::FileKind& programFiles();

}  // namespace lathelier::gcode
