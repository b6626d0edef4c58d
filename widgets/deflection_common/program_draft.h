// An edited program that is not saved yet: part of the project, used by all Deflection panels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/project/project.h"

namespace lathelier::deflection_common {

inline constexpr const char* draftsKey = "drafts";

struct ProgramDraft {
    std::string path;    ///< path of the original file
    std::string sha256;  ///< digest of the original file
    std::string text;    ///< complete text, UTF-8
};

const std::vector<Field<ProgramDraft>>& fieldsOf(const ProgramDraft*);

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

}  // namespace lathelier::deflection_common
