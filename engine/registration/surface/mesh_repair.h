// What a mesh may need before inside and outside can be told: corners that the rounding of a file has split are one
// corner again, facets run round in one sense, small holes are closed.
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
    std::int64_t facets_turned = 0;          ///< triangles that now run round the other way
    std::int64_t holes_filled = 0;           ///< holes closed with added triangles
    double largest_hole_mm = 0;              ///< largest extent of a hole that was filled
};

/// Corners on rims that lie within a thousandth of their rims' edges from each other are taken for one. Facets follow
/// their neighbours' sense; in each connected piece the sense of the larger area, as written, rules. A hole is filled
/// when a single facet fills it, or when it is no larger than a twentieth of the mesh and has up to 100 edges: a larger
/// opening may be meant. Throws Cancelled.
RepairedMesh repairMesh(const Scan& mesh, const Progress& progress = {});

}  // namespace lathelier::registration
