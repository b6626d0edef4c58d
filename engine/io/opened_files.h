// The files whose content this process has read, however they were reached: named, named in another file, or by a link.
// An output must be none of them.
#pragma once

#include <sys/stat.h>

#include <functional>
#include <optional>
#include <string>

namespace lathelier::io {

/// Remembers that the regular file behind `status` was read by this name. From any thread.
void noteOpened(const std::string& path, const struct stat& status);

/// The name by which the file that `path` leads to was read; none where it was not. Links are followed.
std::optional<std::string> openedAs(const std::string& path);

/// `check` is called by every writeFile() before it touches anything; what it throws is thrown there. Set once, before
/// other threads write.
void setWriteCheck(std::function<void()> check);
void checkWrite();

}  // namespace lathelier::io
