// Paths that a file states of others, relative to its own folder where they can be.
#pragma once

#include <string>

namespace lathelier::io {

/// `path` as a file in `folder` states it; empty folder: the working folder.
std::string relativePath(const std::string& folder, const std::string& path);

/// The reverse: `stated` in a file of `folder`, as it can be opened.
std::string openablePath(const std::string& folder, const std::string& stated);

}  // namespace lathelier::io
