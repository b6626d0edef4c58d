// Scans that were read, kept until the user takes what has changed.
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
    ScanFile read(const Source& source, InputFiles& inputs, const Progress& progress) const override;
};

}  // namespace lathelier
