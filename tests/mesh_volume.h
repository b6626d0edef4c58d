// The volume that a closed mesh encloses.
#pragma once

#include "engine/core/scan.h"

namespace lathelier {

/// By the divergence theorem; positive where the triangles run anticlockwise seen from outside.
inline double volumeOf(const Scan& mesh)
{
    double sum = 0;
    for (const auto& t : mesh.triangles)
        sum += mesh.points_mm[t[0]].dot(mesh.points_mm[t[1]].cross(mesh.points_mm[t[2]])) / 6;
    return sum;
}

}  // namespace lathelier
