// Cache of scans, valid until the user accepts changes.
#pragma once

#include "engine/io/cloud/scan_reader.h"
#include "engine/task/file_cache.h"

namespace lathelier {

using LoadedScan = Loaded<io::ScanFile>;
using LoadedScanPtr = std::shared_ptr<const LoadedScan>;

/// Source::import are ImportOptions; errors as readScan().
class ScanStore : public FileCache<io::ScanFile> {
public:
    static constexpr std::size_t capacity = 6;

    ScanStore() : FileCache(capacity) {}

protected:
    io::ScanFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

}  // namespace lathelier
