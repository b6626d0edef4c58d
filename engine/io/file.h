// Files as bytes: reading with located errors, writing without half-written results, digests for the audit.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "engine/core/progress.h"

namespace lathelier {

/// The bytes of a file, mapped into memory where possible.
class FileBytes {
public:
    /// Errors: fileNotFound, notAFile (folder, device, socket), fileNotReadable. An empty file is fine. A pipe is read
    /// to its end, at most 4 GiB; it is refused when nobody writes into it for 5 s. Throws Cancelled while waiting for
    /// a pipe.
    explicit FileBytes(const std::string& path, const Progress& progress = {});
    ~FileBytes();
    FileBytes(FileBytes&&) noexcept;
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    std::string_view view() const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

/// Writes through `write`, which is handed chunks to append, into a file beside `path`, then renames. On any failure,
/// also an exception out of `write`, the file beside is removed and an existing `path` stays as it was. A link is
/// followed, an existing file keeps its permissions, a pipe or device is written to directly.
/// Error fileNotWritable (with the system's reason).
void writeFile(const std::string& path,
               const std::function<void(const std::function<void(std::string_view)>& append)>& write);
void writeFile(const std::string& path, std::string_view content);

/// Lower-case hexadecimal SHA-256. Throws Cancelled.
std::string sha256(std::string_view bytes, const Progress& progress = {});

}  // namespace lathelier
