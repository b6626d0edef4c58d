// Files as bytes: reading with located errors, atomic writing, digests.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "engine/core/progress.h"

namespace lathelier::io {

/// The bytes of a file, copied into memory, so that later changes of the file have no effect.
class FileBytes {
public:
    /// Errors: fileNotFound, notAFile (folder, device, socket), fileNotReadable, fileTooLarge (more than three quarters
    /// of the memory that is free, refused before anything is read), fileChanged (another program wrote into the file
    /// while it was read). An empty file is accepted. A pipe is read to its end, at most 4 GiB; it is rejected without
    /// a writer for 5 s. Throws Cancelled.
    explicit FileBytes(const std::string& path, const Progress& progress = {});
    ~FileBytes();
    FileBytes(FileBytes&&) noexcept;
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    std::string_view view() const;

    /// Releases the memory of the first `count` bytes in whole pages, which then read as zeros. For readers that have
    /// parsed them.
    void release(std::size_t count);

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

/// The largest file that FileBytes takes now: three quarters of the memory that is free.
std::uint64_t largestFile_bytes();

/// Number of bytes read to determine the kind of a file.
inline constexpr std::size_t headForKind = std::size_t{1} << 20;

/// The first `count` bytes of a regular file, or all when it is shorter, to determine its kind. Errors as FileBytes,
/// but a pipe is refused as notAFile: what was read of it would be lost.
std::string fileHead(const std::string& path, std::size_t count);

/// Size, modification time, device and inode of a file: equal stamps mean an unchanged file. Defined for a missing file
/// too.
std::string fileStamp(const std::string& path);

/// Writes through `write`, which receives a function that appends chunks, into a temporary file beside `path`, then
/// renames it. On any failure, also an exception from `write`, the temporary file is removed and an existing `path` is
/// unchanged. A link is followed, an existing file keeps its permissions, a pipe or device is written directly. Error
/// fileNotWritable (with the system's reason).
using Append = std::function<void(std::string_view)>;
void writeFile(const std::string& path, const std::function<void(const Append& append)>& write);
void writeFile(const std::string& path, std::string_view content);

/// A private temporary folder of this process, removed with its content by the destructor; after a crash, by a later
/// process. Error fileNotWritable.
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

/// Lower-case hexadecimal SHA-256. Throws Cancelled. `passed` is called with the number of bytes done.
std::string sha256(std::string_view bytes, const Progress& progress = {},
                   const std::function<void(std::size_t)>& passed = {});

/// The same of a regular file of any size, read in steps. Errors as FileBytes without fileTooLarge.
std::string fileSha256(const std::string& path, const Progress& progress = {});

}  // namespace lathelier::io
