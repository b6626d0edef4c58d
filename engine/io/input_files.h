// The files that an answer rests on: each is read once, and its digest is of the very bytes that were parsed.
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

/// Reads files for one computation. Digests are computed beside the parsing. Not for several threads at once.
class InputFiles {
public:
    /// `beside`: digests may use a thread of their own; else they wait until they are asked for.
    explicit InputFiles(bool beside = true) : beside_(beside) {}

    /// Reads the file and starts its digest. The bytes stay until drop() or the end of this. Errors of FileBytes;
    /// throws Cancelled.
    std::string_view open(const std::string& path, const Progress& progress = {});

    /// A text that stands for the file at `path`, which need not be there: open() gives it. It stays until the end of
    /// this.
    void give(const std::string& path, std::string text) { given_[path] = std::move(text); }

    /// Gives the memory of the first `count` bytes of the file at `path` back, once the digest has passed them.
    void release(const std::string& path, std::size_t count);

    /// Gives the memory of the bytes back, as soon as their digests are there. What open() gave is no longer valid.
    /// Throws Cancelled.
    void drop();

    /// The files opened so far, in that order, with their digests. Throws Cancelled.
    std::vector<InputFile> list();

private:
    struct Entry {
        std::string path;                                  ///< as given to open()
        std::int64_t size = 0;                             ///< in bytes
        std::shared_ptr<FileBytes> bytes;                  ///< the digest holds it too while it is computed
        std::shared_ptr<std::atomic<std::size_t>> hashed;  ///< bytes that the digest has passed
        std::shared_future<std::string> sha256;            ///< digest of the content, lower-case hexadecimal
    };
    std::deque<Entry> entries_;
    std::map<std::string, std::string> given_;  ///< by path
    bool beside_;
};

}  // namespace lathelier::io
