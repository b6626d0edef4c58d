// An archive in one file as a kind of file: it opens the panel Series, and inspect says what it is.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::archive {

/// facts: format "archive"; details "evaluations", "characteristics", "last_recorded_at".
const io::FileKind& archiveFiles();

}  // namespace lathelier::archive
