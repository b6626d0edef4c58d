// ASSIST.json as a kind of file: inspect says which controls it links, and what it answers with.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::link {

/// facts: format "assist"; details "schema_version", "controls" (`link`, as `assist --link` takes it, and
/// `is_verified`), "files" (`role`, `path`; they are not opened), "highest_rpm", "takes_program" (D and L of the loaded
/// program). Errors of loadConfig().
const io::FileKind& assistFiles();

}  // namespace lathelier::link
