// Cache of scans, valid until the user accepts changes.
#pragma once

#include "engine/io/cloud/scan_input.h"
#include "engine/task/inputs.h"

namespace lathelier {

using LoadedScan = Loaded<io::ScanFile>;
using LoadedScanPtr = std::shared_ptr<const LoadedScan>;
using ScanStore = task::CacheOf<io::ScanInput>;

}  // namespace lathelier
