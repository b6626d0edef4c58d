// Limit on the coordinates that a fit accepts.
#pragma once

namespace lathelier::form {

/// Points with a larger coordinate are rejected.
inline constexpr double largestCoordinate_mm = 1e12;

}  // namespace lathelier::form
