// Scans that were read, kept as long as their files stay as they were.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/io/scan_reader.h"
#include "engine/project/project.h"

namespace lathelier {

/// A scan with what a report says of its file.
struct LoadedScan {
    ScanFile file;
    std::int64_t bytes = 0;
    std::string sha256;
};

using LoadedScanPtr = std::shared_ptr<const LoadedScan>;

/// Reads each scan once: a second request with the same path, import options, size and time of change gets the same
/// scan. Safe from any thread; panels call load() inside their job, never in the GUI thread.
class ScanStore {
public:
    /// Errors and Cancelled as readScan. Keeps the last `capacity` scans.
    LoadedScanPtr load(const Source& source, const Progress& progress = {});

    /// What is already there for `source`, as its file was when it was read; nullptr when nothing is. Never reads.
    LoadedScanPtr known(const Source& source) const;

    static constexpr std::size_t capacity = 6;

private:
    struct Entry {
        Source source;
        std::string stamp;  ///< size and time of change
        LoadedScanPtr scan;
    };
    LoadedScanPtr lookUp(const Source& source, const std::string* stamp) const;

    mutable std::mutex mutex_;
    std::vector<Entry> entries_;  ///< oldest first
};

}  // namespace lathelier
