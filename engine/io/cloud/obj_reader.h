// OBJ: a cloud or a mesh.
#pragma once

#include "engine/io/cloud/raw_scan.h"

namespace lathelier::io {

RawScan readObj(const ScanSource& source);

}  // namespace lathelier::io
