// Dossiers as a kind of file: `inspect dossier.json` follows every digest and number again.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::chain {

/// facts: format "dossier"; details "files", "numbers" (followed), "faults" [{step, what, path, pointer, gone}],
/// "unchanged".
const io::FileKind& dossierFiles();

}  // namespace lathelier::chain
