// Factors between the units of receptances.
#pragma once

namespace lathelier::receptance {

inline constexpr double nm_per_mm = 1e6;

}  // namespace lathelier::receptance
