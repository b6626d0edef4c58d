// Scans of the sample as PLY files marked as synthetic.
#pragma once

#include <string>

#include "engine/core/scan.h"

namespace lathelier::sample {

inline constexpr char syntheticScan[] = "synthetic: ray-cast scan made by Lathelier, not a measurement";

/// Binary little-endian PLY with float coordinates.
std::string scanPly(const Scan& scan);

}  // namespace lathelier::sample
