// Effect of the spot of an optical scanner near edges.
#pragma once

namespace lathelier::registration {

/// Distance from an edge within which the scanner's spot smears the surface.
inline constexpr double smearedEdge_mm = 0.5;

}  // namespace lathelier::registration
