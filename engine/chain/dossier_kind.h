// Dossiers as a kind of file: `inspect dossier.json` verifies every digest and number.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::chain {

/// facts: format "dossier"; details "files", "numbers" (checked), "faults" [{step, what, path, pointer, gone}],
/// "unchanged".
const io::FileKind& dossierFiles();

}  // namespace lathelier::chain
