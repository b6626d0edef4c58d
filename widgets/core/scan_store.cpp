#include "widgets/core/scan_store.h"

#include <algorithm>
#include <filesystem>

#include "engine/io/file.h"

namespace lathelier {
namespace {

std::string stampOf(const std::string& path)
{
    std::error_code problem;  // a missing file is reported by the reader
    const auto size = std::filesystem::file_size(path, problem);
    const auto changed = std::filesystem::last_write_time(path, problem);
    return std::to_string(size) + "@" + std::to_string(changed.time_since_epoch().count());
}

bool sameFile(const Source& a, const Source& b)
{
    return a.path == b.path && a.import == b.import;
}

LoadedScanPtr read(const Source& source, const Progress& progress)
{
    const FileBytes bytes(source.path);
    auto scan = std::make_shared<LoadedScan>();
    scan->file = readScan(source.path, bytes.view(), fromValues<ImportOptions>(source.import), progress.part(0, 0.9));
    progress.report(0.9);
    scan->bytes = static_cast<std::int64_t>(bytes.view().size());
    scan->sha256 = sha256(bytes.view());
    return scan;
}

}  // namespace

LoadedScanPtr ScanStore::lookUp(const Source& source, const std::string* stamp) const
{
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_)
        if (sameFile(entry.source, source) && (!stamp || entry.stamp == *stamp)) return entry.scan;
    return nullptr;
}

LoadedScanPtr ScanStore::load(const Source& source, const Progress& progress)
{
    const std::string stamp = stampOf(source.path);
    if (LoadedScanPtr scan = lookUp(source, &stamp)) return scan;
    LoadedScanPtr scan = read(source, progress);

    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [&](const Entry& entry) { return sameFile(entry.source, source); });
    entries_.push_back({source, stamp, scan});
    if (entries_.size() > capacity) entries_.erase(entries_.begin());
    return scan;
}

LoadedScanPtr ScanStore::known(const Source& source) const
{
    return lookUp(source, nullptr);
}

}  // namespace lathelier
