// Cache of files read, valid until the user accepts changes on disk.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <list>
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

    /// Drops the file at `path`, read as it may, so that nothing of it is kept; the next load() reads it again.
    virtual void forget(const std::string& path) = 0;
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
/// has changed; one that comes while the first reads waits for it. Thread-safe; panels call load() inside their job,
/// not in the GUI thread.
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
        const Turn turn = knownOrOurs(source, progress);
        if (turn.there) return turn.there;
        const Reading reading{*this, turn.place};
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
        return found(source);
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
        for (const std::string& path : gone) drop(path);
        return !gone.empty();
    }

    void forget(const std::string& path) override
    {
        const std::lock_guard lock(mutex_);
        drop(path);
    }

protected:
    /// Opens source.path and its partner files with `inputs`.
    virtual File read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const = 0;

private:
    struct Entry {
        project::Source source;  ///< path and import options of the request
        Pointer loaded;          ///< never null
    };

    using Place = std::list<project::Source>::const_iterator;

    /// Ends the reading of a file, with content or without.
    struct Reading {
        FileCache& cache;
        Place place;

        ~Reading()
        {
            const std::lock_guard lock(cache.mutex_);
            cache.reading_.erase(place);
            cache.read_.notify_all();
        }
    };

    struct Turn {
        Pointer there;  ///< null: the caller reads the file
        Place place;    ///< in reading_, where the caller reads it
    };

    /// The content, after the end of a reading under way.
    Turn knownOrOurs(const project::Source& source, const Progress& progress)
    {
        std::unique_lock lock(mutex_);
        for (;;) {
            if (Pointer there = found(source)) return {there, {}};
            if (std::none_of(reading_.begin(), reading_.end(),
                             [&](const project::Source& one) { return sameFile(one, source); }))
                break;
            read_.wait_for(lock, std::chrono::milliseconds(10));
            lock.unlock();
            progress.check();
            lock.lock();
        }
        return {nullptr, reading_.insert(reading_.end(), source)};
    }

    /// With the lock held, likewise drop().
    Pointer found(const project::Source& source) const
    {
        for (const Entry& entry : entries_)
            if (sameFile(entry.source, source)) return entry.loaded;
        return nullptr;
    }

    void drop(const std::string& path)
    {
        seen_.erase(path);
        std::erase_if(entries_, [&](const Entry& entry) {
            return std::any_of(entry.loaded->inputs.begin(), entry.loaded->inputs.end(),
                               [&](const InputFile& input) { return input.path == path; });
        });
    }

    static bool sameFile(const project::Source& a, const project::Source& b)
    {
        return a.path == b.path && a.import == b.import;
    }

    std::size_t capacity_;
    mutable std::mutex mutex_;
    std::condition_variable read_;          ///< notified when a reading has ended
    std::list<project::Source> reading_;    ///< being read
    std::vector<Entry> entries_;            ///< cached entries, oldest first
    std::map<std::string, FileSeen> seen_;  ///< state of all files read, by path
};

}  // namespace lathelier
