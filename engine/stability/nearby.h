// Limits near a speed: what the natural frequencies are known to decides how wide a pocket has to be.
#pragma once

#include <vector>

namespace lathelier::stability {

/// ± share of a speed within which the limit has to hold.
inline constexpr double robustShare = 0.02;

/// The least depth within ±robustShare of each speed, as far as it is known. Speeds ascend. Cost: O(speeds).
std::vector<double> leastNearby(const std::vector<double>& speed_rpm, const std::vector<double>& depth);

}  // namespace lathelier::stability
