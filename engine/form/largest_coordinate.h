// The coordinates that a fit takes.
#pragma once

namespace lathelier::form {

/// Points further out are refused.
inline constexpr double largestCoordinate_mm = 1e12;

}  // namespace lathelier::form
