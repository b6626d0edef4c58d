// A surface that points can be measured against: a triangle mesh, or a cloud with a smooth surface through it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/neighbours/neighbours.h"

namespace lathelier::registration {

/// Signed distance of a point from the surface and the normal there. `distance_mm` is NaN when no surface is within
/// reach.
struct SurfacePlace {
    double distance_mm = std::numeric_limits<double>::quiet_NaN();  ///< from the surface to the point along `normal`
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit; out of the material once the surface is oriented
    double slope_variance =
        0;                ///< of the normal's tangent in each direction, from the noise of the surface's own points
    bool border = false;  ///< the foot of the point lies on an open border: no deviation is defined

    bool found() const { return distance_mm == distance_mm; }
};

/// Read by several threads at once, except for orient().
class Surface {
public:
    virtual ~Surface() = default;

    using Trace = Neighbours::Trace;

    /// Where each of the queries (finite, in Hilbert order) lies; found only up to `max_distance_mm`. `traces` speed up
    /// a repeated call with the same points slightly moved; empty for a single call.
    virtual void place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm,
                       std::span<SurfacePlace> places, std::span<Trace> traces) const = 0;

    /// Orients the normals out of the material. False when inside and outside are not determined.
    virtual bool orient(const Progress& progress) = 0;

    /// One standard deviation of the surface's own points about it; 0 for a mesh.
    virtual double scatter_mm() const = 0;

    /// Number of noisy points the surface is made from; 0 for a mesh.
    virtual std::size_t pointCount() const = 0;

    /// The cloud the surface was made from; nullptr for a mesh.
    virtual const Neighbours* points() const = 0;

    /// How far from a place of the surface its points typically lie; 0 for a mesh.
    virtual double spacing_mm() const = 0;

    /// Notes on repairs made before the surface could be used.
    virtual Notes notes() const { return {}; }
};

/// Of a mesh the triangles, of a cloud the patches through its points. Throws Cancelled, and tooFewPoints for a cloud
/// of fewer than 4 points.
std::unique_ptr<Surface> makeSurface(const Scan& scan, const Progress& progress);

}  // namespace lathelier::registration
