// A program that the user has changed and not saved yet: part of the project, and what all panels of Deflection answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/project/project.h"

namespace lathelier::deflection_common {

inline constexpr const char* draftsKey = "drafts";

struct ProgramDraft {
    std::string path;    ///< of the file that was changed
    std::string sha256;  ///< of that file as it was read
    std::string text;    ///< the whole program, UTF-8
};

const std::vector<Field<ProgramDraft>>& fieldsOf(const ProgramDraft*);

/// Whether it was made of this file, which may have moved since with the project: by path, or by name and digest.
bool isOf(const ProgramDraft& draft, const std::string& path, const std::string& sha256);

/// nullptr: the file is as it was read.
const ProgramDraft* draftOf(const std::vector<ProgramDraft>& drafts, const std::string& path,
                            const std::string& sha256);

/// The text of a file in UTF-8: as it is, or its Latin-1 made UTF-8.
std::string toUtf8(const std::string& bytes);

/// What is written for a text in UTF-8 in place of the bytes of a file: Latin-1 stays Latin-1, unless the text has
/// characters that Latin-1 has not.
std::string bytesOf(const std::string& utf8, const std::string& file);

}  // namespace lathelier::deflection_common
