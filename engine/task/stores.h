// Objects shared by panels beside the project: file caches, results shown by several panels.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

#include "engine/task/file_cache.h"

namespace lathelier {

/// One object of each type, created on first use. Thread-safe; the types must be as well.
class Stores {
public:
    template <class T>
    std::shared_ptr<T> of()
    {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<void>& place = stores_[typeid(T)];
        if (!place) {
            auto made = std::make_shared<T>();
            place = made;
            if constexpr (std::is_base_of_v<FileStore, T>) files_.push_back(made);
        }
        return std::static_pointer_cast<T>(place);
    }

    /// SHA-256 of the content read for `source` by any store.
    std::optional<std::string> digest(const project::Source& source) const
    {
        const std::lock_guard lock(mutex_);
        for (const auto& store : files_)
            if (auto found = store->digest(source)) return found;
        return std::nullopt;
    }

    /// All files that were read, by any store.
    std::vector<FileSeen> seen() const
    {
        const std::lock_guard lock(mutex_);
        std::vector<FileSeen> all;
        for (const auto& store : files_)
            for (FileSeen& file : store->seen()) all.push_back(std::move(file));
        return all;
    }

    /// Drops the file at `path` from every store.
    void forget(const std::string& path)
    {
        const std::lock_guard lock(mutex_);
        for (const auto& store : files_) store->forget(path);
    }

    /// Drops files changed or missing on disk; true when there were any.
    bool forgetChanged()
    {
        const std::lock_guard lock(mutex_);
        bool any = false;
        for (const auto& store : files_) any = store->forgetChanged() || any;
        return any;
    }

private:
    mutable std::mutex mutex_;
    std::map<std::type_index, std::shared_ptr<void>> stores_;
    std::vector<std::shared_ptr<FileStore>> files_;
};

}  // namespace lathelier
