// A cloud as a table in a text file.
#pragma once

#include "engine/io/cloud/raw_scan.h"

namespace lathelier::io {

RawScan readTextScan(const ScanSource& source);

}  // namespace lathelier::io
