// The input files of a result: each is read once, and its digest is that of the parsed bytes.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/input_file.h"
#include "engine/io/file.h"

namespace lathelier::io {

/// Reads files for one computation. Digests are computed concurrently with the parsing. Not thread-safe.
class InputFiles {
public:
    /// `beside`: digests may use another thread; else they are computed on request.
    explicit InputFiles(bool beside = true) : beside_(beside) {}

    /// Reads the file and starts its digest. The bytes are valid until drop() or destruction. Errors of FileBytes;
    /// throws Cancelled.
    std::string_view open(const std::string& path, const Progress& progress = {});

    /// A text used in place of the file at `path`, which need not exist: open() returns it. It is valid until
    /// destruction.
    void give(const std::string& path, std::string text) { given_[path] = std::move(text); }

    /// Releases the memory of the first `count` bytes of the file at `path` once the digest has passed them.
    void release(const std::string& path, std::size_t count);

    /// Releases the bytes as soon as their digests exist. Views returned by open() become invalid. Throws Cancelled.
    void drop();

    /// The files opened so far, in that order, with their digests. Throws Cancelled.
    std::vector<InputFile> list();

private:
    struct Entry {
        std::string path;                                  ///< as given to open()
        std::int64_t size = 0;                             ///< in bytes
        std::shared_ptr<FileBytes> bytes;                  ///< shared with the digest while it is computed
        std::shared_ptr<std::atomic<std::size_t>> hashed;  ///< bytes processed by the digest
        std::shared_future<std::string> sha256;            ///< digest of the content, lower-case hexadecimal
    };
    std::deque<Entry> entries_;
    std::map<std::string, std::string> given_;  ///< substitute texts by path
    bool beside_;
};

}  // namespace lathelier::io
