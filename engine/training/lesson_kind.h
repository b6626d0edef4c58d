// Lessons as a kind of file: dropped on the window or named on its command line, one opens in the panel Training.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::training {

/// Markdown whose first line of text is a title. facts: format "lesson"; details "title", "steps".
const io::FileKind& lessonFiles();

}  // namespace lathelier::training
