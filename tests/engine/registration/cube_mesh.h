// A cube as a closed mesh.
#pragma once

#include "engine/core/scan.h"

namespace lathelier::registration {

/// One corner at the origin, the others along the axes.
inline Scan cube(double side)
{
    Scan scan;
    for (int i = 0; i < 8; ++i) scan.points_mm.emplace_back(side * (i & 1), side * (i >> 1 & 1), side * (i >> 2 & 1));
    scan.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return scan;
}

}  // namespace lathelier::registration
