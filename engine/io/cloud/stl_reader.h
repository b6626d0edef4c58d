// STL: a mesh.
#pragma once

#include "engine/io/cloud/raw_scan.h"

namespace lathelier::io {

RawScan readBinaryStl(const ScanSource& source);
RawScan readAsciiStl(const ScanSource& source);

}  // namespace lathelier::io
