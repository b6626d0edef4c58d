// An edited program that is not saved yet: part of the project, used by all panels that read programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"

namespace lathelier::gcode {

inline constexpr const char* draftsKey = "drafts";

struct ProgramDraft {
    std::string path;    ///< path of the original file
    std::string sha256;  ///< digest of the original file
    std::string text;    ///< complete text, UTF-8
};

const std::vector<Field<ProgramDraft>>& fieldsOf(const ProgramDraft*);

/// The drafts of a question, kept by a window.
template <class Q>
Field<Q> draftsField(std::vector<ProgramDraft> Q::*drafts)
{
    Field<Q> field = rows(draftsKey, drafts, Range{0, 1000},
                          Label{LT_TEXT("Engine", "Changed programs"), LT_TEXT("Engine", "Not saved yet."), {}, true});
    field.info.is_kept = true;
    return field;
}

/// Whether it is a draft of this file, which may have moved with the project: by path, or by name and digest.
bool isOf(const ProgramDraft& draft, const std::string& path, const std::string& sha256);

/// nullptr: the file is unedited.
const ProgramDraft* draftOf(const std::vector<ProgramDraft>& drafts, const std::string& path,
                            const std::string& sha256);

/// The text of a file in UTF-8, converted from Latin-1 where necessary.
std::string toUtf8(const std::string& bytes);

/// Bytes to be written for an edited text: Latin-1 if the original was Latin-1 and the text is representable, else
/// UTF-8.
std::string bytesOf(const std::string& utf8, const std::string& file);

}  // namespace lathelier::gcode
