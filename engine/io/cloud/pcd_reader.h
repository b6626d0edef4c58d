// PCD: a cloud.
#pragma once

#include "engine/io/cloud/raw_scan.h"

namespace lathelier::io {

RawScan readPcd(const ScanSource& source);  ///< ascii from `text`, binary from `bytes`

}  // namespace lathelier::io
