// Scans that were read, kept as long as their files stay as they were.
#pragma once

#include "engine/io/scan_reader.h"
#include "widgets/core/file_cache.h"

namespace lathelier {

using LoadedScan = Loaded<ScanFile>;
using LoadedScanPtr = std::shared_ptr<const LoadedScan>;

/// Source::import are ImportOptions; errors as readScan().
class ScanStore : public FileCache<ScanFile> {
public:
    static constexpr std::size_t capacity = 6;

    ScanStore() : FileCache(capacity) {}

protected:
    ScanFile read(const Source& source, std::string_view bytes, const Progress& progress) const override;
};

}  // namespace lathelier
