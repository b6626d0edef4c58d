// What the spot of an optical scanner does to a surface.
#pragma once

namespace lathelier::registration {

/// The scanner's spot smears what lies nearer to an edge.
inline constexpr double smearedEdge_mm = 0.5;

}  // namespace lathelier::registration
