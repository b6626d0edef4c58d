// PLY: a cloud or a mesh.
#pragma once

#include "engine/io/cloud/raw_scan.h"

namespace lathelier::io {

RawScan readPly(const ScanSource& source);  ///< ascii from `text`, binary from `bytes`

}  // namespace lathelier::io
