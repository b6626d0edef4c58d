// Files as bytes: reading with located errors, writing without half-written results, digests for the audit.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace lathelier {

/// The bytes of a file, mapped into memory where possible.
class FileBytes {
public:
    /// Errors: FileNotFound, NotAFile (folder, device; a pipe is read to its end), FileNotReadable. An empty file is fine.
    explicit FileBytes(const std::string& path);
    ~FileBytes();
    FileBytes(FileBytes&&) noexcept;
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    std::string_view view() const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

/// Writes through `write`, which is handed chunks to append, into a file beside `path`, then renames. On any failure
/// the file beside is removed and an existing `path` stays as it was. Error FileNotWritable (with the system's reason).
void writeFile(const std::string& path, const std::function<void(const std::function<void(std::string_view)>& append)>& write);
void writeFile(const std::string& path, std::string_view content);

/// Lower-case hexadecimal SHA-256.
std::string sha256(std::string_view bytes);

}  // namespace lathelier
