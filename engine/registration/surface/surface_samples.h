// Points spread evenly over the triangles of a mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/scan.h"

namespace lathelier::registration {

/// A place in a triangle: a + s·(b - a) + t·(c - a) of its corners a, b, c.
struct SurfaceSample {
    std::uint32_t triangle = 0;  ///< index into Scan::triangles
    double s = 0, t = 0;         ///< neither negative, s + t at most 1
};

/// The places that sampleSurface() gives.
std::vector<SurfaceSample> drawSamples(const Scan& mesh, std::size_t count, std::uint64_t seed = 0,
                                       const Progress& progress = {});

/// `count` points of the mesh's surface, each standing for the same area, with the unit normals of their triangles.
/// Stratified: the i-th point lies in the i-th of `count` equal shares of the area, in the order of the triangles, at a
/// place in its triangle drawn by `seed`. The same for any number of threads. A mesh without area gives no points.
Scan sampleSurface(const Scan& mesh, std::size_t count, std::uint64_t seed = 0, const Progress& progress = {});

}  // namespace lathelier::registration
