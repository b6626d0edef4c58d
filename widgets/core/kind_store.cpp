#include "widgets/core/kind_store.h"

#include "widgets/core/file_cache.h"

namespace lathelier {

FoundFile KindStore::find(const FileKinds& kinds, const std::string& path)
{
    const std::string stamp = fileStamp(path);
    const KindFound found = findKind(kinds, path);
    FoundFile file{path, found.kind, found.likeness};
    const std::lock_guard lock(mutex_);
    entries_.insert_or_assign(path, Entry{file, stamp});
    return file;
}

std::optional<FoundFile> KindStore::known(const std::string& path) const
{
    const std::string stamp = fileStamp(path);
    const std::lock_guard lock(mutex_);
    const auto entry = entries_.find(path);
    if (entry == entries_.end() || entry->second.stamp != stamp) return std::nullopt;
    return entry->second.file;
}

}  // namespace lathelier
