// Repair of a mesh before inside and outside are determined: corners split by rounding in a file are merged, facets are
// oriented consistently, small holes are closed.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/surface/mesh_edges.h"

namespace lathelier::registration {

/// The mesh with the same vertices; nothing is moved.
struct RepairedMesh {
    CornerNumbers corners;                   ///< numbers of the vertices after merging
    std::vector<TriangleCorners> triangles;  ///< those of the mesh in their order, some turned, and those added
    std::int64_t facets_turned = 0;          ///< triangles whose orientation was reversed
    std::int64_t holes_filled = 0;           ///< holes closed with added triangles
    double largest_hole_mm = 0;              ///< largest extent of a hole that was filled
};

/// Corners on rims that lie within a thousandth of their rims' edges from each other are merged. Facets follow
/// their neighbours' sense; each connected piece takes the orientation that most of its area has in the file. A hole is
/// filled when a single facet fills it, or when it is no larger than a twentieth of the mesh and has up to 100 edges: a
/// larger opening may be intended. Throws Cancelled.
RepairedMesh repairMesh(const Scan& mesh, const Progress& progress = {});

}  // namespace lathelier::registration
