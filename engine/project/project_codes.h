// Error and note codes of project files, with their English patterns. {name} is replaced by the named value; text()
// prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode versionTooNew{
    "version_too_new", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The project has format version {found}; this program reads up to version {maximum}.")};

inline constexpr ErrorCode sourceReplaced{
    "source_replaced", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The file is no longer the one that was read: SHA-256 was {read}…, is {now}…. Compute again "
            "(F5) to take the new file.")};

inline constexpr ErrorCode itemNotThere{
    "item_not_there", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The project has no “{item}” of the kind {kind}: keep it again, or choose a file.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode sourceChanged{"source_changed", Severity::Warning,
                                        LT_TEXT("Engine", "{path} has changed since the project was saved.")};

inline constexpr NoteCode sourceChangedSince{
    "source_changed_since", Severity::Warning,
    LT_TEXT("Engine",
            "{path} was changed after it was read: SHA-256 was {read}…, is {now}…. This answer is of the "
            "file as it was; compute again (F5) to take the new one.")};

inline constexpr NoteCode sourceGone{
    "source_gone", Severity::Warning,
    LT_TEXT("Engine", "{path} is no longer there. This answer is of the file as it was, SHA-256 {read}….")};

inline constexpr NoteCode sourceMissing{"source_missing", Severity::Warning, LT_TEXT("Engine", "{path} is missing.")};

}  // namespace notes

}  // namespace lathelier
