// Polygons of a file as triangles.
#pragma once

#include <span>

#include "engine/core/error.h"
#include "engine/core/scan.h"

namespace lathelier::io {

/// Adds a polygon as a fan of triangles around its first corner (exact for convex polygons). Polygons with fewer than
/// three corners are skipped. Error malformed at `place` when a corner is no vertex of the scan.
void addPolygon(Scan& scan, std::span<const std::int64_t> corners, const Values& place);

}  // namespace lathelier::io
