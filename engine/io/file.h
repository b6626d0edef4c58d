// Files as bytes: reading with located errors, writing without half-written results, digests for the audit.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "engine/core/progress.h"

namespace lathelier::io {

/// The bytes of a file, copied into memory: what another program does to the file later changes nothing here.
class FileBytes {
public:
    /// Errors: fileNotFound, notAFile (folder, device, socket), fileNotReadable, fileTooLarge (more than three quarters
    /// of the memory that is free, refused before anything is read), fileChanged (another program wrote into the file
    /// while it was read). An empty file is fine. A pipe is read to its end, at most 4 GiB; it is refused when nobody
    /// writes into it for 5 s. Throws Cancelled.
    explicit FileBytes(const std::string& path, const Progress& progress = {});
    ~FileBytes();
    FileBytes(FileBytes&&) noexcept;
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    std::string_view view() const;

    /// Gives the memory of the first `count` bytes back to the system, as far as whole pages go: they read as zeros
    /// from then on. For readers that have parsed them.
    void release(std::size_t count);

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

/// The largest file that FileBytes takes now: three quarters of the memory that is free.
std::uint64_t largestFile_bytes();

/// So many bytes tell the kind of a file.
inline constexpr std::size_t headForKind = std::size_t{1} << 20;

/// The first `count` bytes of a regular file, or all when it is shorter: to tell its kind. Errors as FileBytes, but a
/// pipe is refused as notAFile: what was read of it would be lost.
std::string fileHead(const std::string& path, std::size_t count);

/// Size and time of the last change of a file, with its place on the disk: equal stamps mean an untouched file. A
/// missing file has a stamp too.
std::string fileStamp(const std::string& path);

/// Writes through `write`, which is handed chunks to append, into a file beside `path`, then renames. On any failure,
/// also an exception out of `write`, the file beside is removed and an existing `path` stays as it was. A link is
/// followed, an existing file keeps its permissions, a pipe or device is written to directly.
/// Error fileNotWritable (with the system's reason).
using Append = std::function<void(std::string_view)>;
void writeFile(const std::string& path, const std::function<void(const Append& append)>& write);
void writeFile(const std::string& path, std::string_view content);

/// A folder of this process alone in the system's place for temporary files, removed with all that is in it at the end
/// of its life; after a crash, by a later program. Error fileNotWritable.
class PartFolder {
public:
    PartFolder();
    ~PartFolder();
    PartFolder(const PartFolder&) = delete;
    PartFolder& operator=(const PartFolder&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

/// Lower-case hexadecimal SHA-256. Throws Cancelled.
/// `passed` hears how many bytes are done.
std::string sha256(std::string_view bytes, const Progress& progress = {},
                   const std::function<void(std::size_t)>& passed = {});

/// The same of a regular file, read in steps: any size will do. Errors as FileBytes without fileTooLarge.
std::string fileSha256(const std::string& path, const Progress& progress = {});

}  // namespace lathelier::io
