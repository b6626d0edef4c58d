// Files that were read, kept as long as they stay as they were.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/io/file.h"
#include "engine/project/project.h"

namespace lathelier {

/// What the window has to know of a store of files, whatever they hold.
class FileStore {
public:
    virtual ~FileStore() = default;

    /// SHA-256 of what was read for `source`; nullopt when it was not read. Never reads.
    virtual std::optional<std::string> digest(const Source& source) const = 0;
};

/// A file's content with what a report says of the file.
template <class File>
struct Loaded {
    File file;
    std::int64_t bytes = 0;
    std::string sha256;
};

/// Size and time of change; a missing file has a stamp too, its reader complains.
std::string fileStamp(const std::string& path);

/// Reads each file once: a second request with the same path, import options, size and time of change gets the same
/// content. Safe from any thread; panels call load() inside their job, never in the GUI thread.
template <class File>
class FileCache : public FileStore {
public:
    using Pointer = std::shared_ptr<const Loaded<File>>;

    /// Keeps the last `capacity` files.
    explicit FileCache(std::size_t capacity) : capacity_(capacity) {}

    /// Errors and Cancelled as the reader.
    Pointer load(const Source& source, const Progress& progress = {})
    {
        const std::string stamp = fileStamp(source.path);
        if (Pointer known = lookUp(source, &stamp)) return known;
        const FileBytes bytes(source.path);
        auto loaded = std::make_shared<Loaded<File>>();
        loaded->file = read(source, bytes.view(), progress.part(0, 0.9));
        progress.report(0.9);
        loaded->bytes = static_cast<std::int64_t>(bytes.view().size());
        loaded->sha256 = sha256(bytes.view(), progress);

        const std::lock_guard lock(mutex_);
        std::erase_if(entries_, [&](const Entry& entry) { return sameFile(entry.source, source); });
        entries_.push_back({source, stamp, loaded});
        if (entries_.size() > capacity_) entries_.erase(entries_.begin());
        return loaded;
    }

    /// What is already there for `source`, as its file was when it was read; nullptr when nothing is. Never reads.
    Pointer known(const Source& source) const { return lookUp(source, nullptr); }

    std::optional<std::string> digest(const Source& source) const override
    {
        const Pointer loaded = known(source);
        return loaded ? std::optional(loaded->sha256) : std::nullopt;
    }

protected:
    virtual File read(const Source& source, std::string_view bytes, const Progress& progress) const = 0;

private:
    struct Entry {
        Source source;
        std::string stamp;
        Pointer loaded;
    };

    static bool sameFile(const Source& a, const Source& b) { return a.path == b.path && a.import == b.import; }

    Pointer lookUp(const Source& source, const std::string* stamp) const
    {
        const std::lock_guard lock(mutex_);
        for (const Entry& entry : entries_)
            if (sameFile(entry.source, source) && (!stamp || entry.stamp == *stamp)) return entry.loaded;
        return nullptr;
    }

    std::size_t capacity_;
    mutable std::mutex mutex_;
    std::vector<Entry> entries_;  ///< oldest first
};

}  // namespace lathelier
