// The order along a Hilbert curve: consecutive points are near each other for any distribution.
// Source: C. H. Hamilton, A. Rau-Chaplin, "Compact Hilbert indices", Information Processing Letters 105 (2008), the
// algorithm for equal side lengths.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

/// Place of a cell on the Hilbert curve through 1024³ cells; cell coordinates 0…1023. Neighbours on the curve share a
/// face.
std::uint32_t hilbertPlace(const std::array<std::uint32_t, 3>& cell);

/// The indices of `points_mm` (finite, any unit) along a Hilbert curve that is refined wherever points are dense, so
/// that clusters and far outliers do not slow it down. Equal points keep their order. Time n log n at worst; the same
/// for any number of threads. Throws Cancelled.
std::vector<std::uint32_t> hilbertOrder(const std::vector<Eigen::Vector3d>& points_mm, const Progress& progress = {});

}  // namespace lathelier::registration
