// What project files refuse or remark: codes with their English patterns. {name} is replaced by the named value; text()
// puts path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode versionTooNew{
    "version_too_new", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The project has format version {found}; this program reads up to version {maximum}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode sourceChanged{"source_changed", Severity::Warning,
                                        LT_TEXT("Engine", "{path} has changed since the project was saved.")};

inline constexpr NoteCode sourceMissing{"source_missing", Severity::Warning, LT_TEXT("Engine", "{path} is missing.")};

}  // namespace notes

}  // namespace lathelier
