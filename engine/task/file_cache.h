// Cache of files read, valid until the user accepts changes on disk.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/io/input_files.h"
#include "engine/project/project.h"

namespace lathelier {

/// State of a file when it was read.
struct FileSeen {
    std::string path;    ///< as it was opened
    std::string stamp;   ///< fileStamp() when it was read
    std::string sha256;  ///< of the content that was read
};

/// Interface of a file cache independent of the content. Thread-safe.
class FileStore {
public:
    virtual ~FileStore() = default;

    /// SHA-256 of what was read for `source`; nullopt when it was not read. Does not read.
    virtual std::optional<std::string> digest(const project::Source& source) const = 0;

    /// All cached files.
    virtual std::vector<FileSeen> seen() const = 0;

    /// Drops files changed or missing on disk, so that the next load() reads them again. True when there were any.
    virtual bool forgetChanged() = 0;
};

/// Content of a file with the report entries of it and of its partner files.
template <class File>
struct Loaded {
    File file;                      ///< result of the reader
    std::vector<InputFile> inputs;  ///< the file itself first

    /// Digest that identifies the content.
    std::string digest() const
    {
        std::string all;
        for (const InputFile& input : inputs) all += input.sha256;
        return all;
    }
};

/// Abbreviated digest for messages.
std::string shortDigest(const std::string& sha256);

/// Error sourceReplaced: `path` was read before, with other content.
void requireSame(const FileSeen& before, const InputFile& now);

/// Reads each file once: a second request with equal path and import options returns the same content even if the file
/// has changed. Thread-safe; panels call load() inside their job, not in the GUI thread.
template <class File>
class FileCache : public FileStore {
public:
    using Pointer = std::shared_ptr<const Loaded<File>>;

    /// Keeps the last `capacity` files.
    explicit FileCache(std::size_t capacity) : capacity_(capacity) {}

    /// Errors and Cancelled as the reader; sourceReplaced when the file has to be read again (for other import options)
    /// and has changed.
    Pointer load(const project::Source& source, const Progress& progress = {})
    {
        if (Pointer there = known(source)) return there;
        const std::string stamp = io::fileStamp(source.path);
        io::InputFiles inputs;
        auto loaded = std::make_shared<Loaded<File>>();
        loaded->file = read(source, inputs, progress.part(0, 0.9));
        inputs.drop();
        progress.report(0.9);
        loaded->inputs = inputs.list();

        const std::lock_guard lock(mutex_);
        for (const InputFile& input : loaded->inputs) {
            const auto before = seen_.find(input.path);
            if (before != seen_.end()) requireSame(before->second, input);
        }
        for (const InputFile& input : loaded->inputs)
            seen_.insert_or_assign(
                input.path,
                FileSeen{input.path, input.path == source.path ? stamp : io::fileStamp(input.path), input.sha256});
        std::erase_if(entries_, [&](const Entry& entry) { return sameFile(entry.source, source); });
        entries_.push_back({source, loaded});
        if (entries_.size() > capacity_) entries_.erase(entries_.begin());
        return loaded;
    }

    /// The cached content for `source`; nullptr when there is none. Does not read.
    Pointer known(const project::Source& source) const
    {
        const std::lock_guard lock(mutex_);
        for (const Entry& entry : entries_)
            if (sameFile(entry.source, source)) return entry.loaded;
        return nullptr;
    }

    std::optional<std::string> digest(const project::Source& source) const override
    {
        const Pointer loaded = known(source);
        return loaded ? std::optional(loaded->inputs.front().sha256) : std::nullopt;
    }

    std::vector<FileSeen> seen() const override
    {
        const std::lock_guard lock(mutex_);
        std::vector<FileSeen> result;
        for (const auto& [path, file] : seen_) result.push_back(file);
        return result;
    }

    bool forgetChanged() override
    {
        const std::lock_guard lock(mutex_);
        std::vector<std::string> gone;
        for (const auto& [path, file] : seen_)
            if (io::fileStamp(path) != file.stamp) gone.push_back(path);
        for (const std::string& path : gone) {
            seen_.erase(path);
            std::erase_if(entries_, [&](const Entry& entry) {
                return std::any_of(entry.loaded->inputs.begin(), entry.loaded->inputs.end(),
                                   [&](const InputFile& input) { return input.path == path; });
            });
        }
        return !gone.empty();
    }

protected:
    /// Opens source.path and its partner files with `inputs`.
    virtual File read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const = 0;

private:
    struct Entry {
        project::Source source;  ///< path and import options of the request
        Pointer loaded;          ///< never null
    };

    static bool sameFile(const project::Source& a, const project::Source& b)
    {
        return a.path == b.path && a.import == b.import;
    }

    std::size_t capacity_;
    mutable std::mutex mutex_;
    std::vector<Entry> entries_;            ///< cached entries, oldest first
    std::map<std::string, FileSeen> seen_;  ///< state of all files read, by path
};

}  // namespace lathelier
