// Diameters of round steel bars that are sold: the preferred ones of EN 10060 (hot rolled).
#pragma once

#include <optional>
#include <vector>

namespace lathelier::shop {

/// In mm, ascending.
const std::vector<double>& barDiameters_mm();

/// The smallest that is not below `diameter_mm`; none: larger than all.
std::optional<double> barFor_mm(double diameter_mm);

}  // namespace lathelier::shop
