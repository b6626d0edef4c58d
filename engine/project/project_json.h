// A project as JSON text. Format version 7:
//   {"format": "lathelier-project", "version": 7, "title", "workspace", "recipe": true, "shop": {…}, "shown": 0,
//    "parts": [{"name", "panels": {id: {"inputs": {role: {"path" | "item", "import": {…}, "sha256", "synthetic"}},
//                                       "parameters": {…}}},
//               "items": {name: {"kind", "values": {…}, "origin": {…}}}, "views": {id: {…}}, "title_block": {…},
//               "report": [id…]}]}
// "shown" counts from 0. Up to version 6 the members of the one part stand at the top.
// Everything but format and version may be missing. A key that is not known is refused, so that a misspelt key in a
// hand-written file is found; names inside "import" and "parameters" belong to the panels and are kept.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/project/project.h"

namespace lathelier::project {

/// Reads a project whose relative paths start at `folder`. Errors: malformed (line, column), versionTooNew.
Project parseProject(std::string_view text, const std::filesystem::path& folder);

/// Writes a project whose paths are to be relative to `folder`.
std::string toJsonText(const Project& project, const std::filesystem::path& folder);

}  // namespace lathelier::project
