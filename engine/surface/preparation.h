// A picture before its spectrum is taken: a part of it, made smaller, unrolled, and without its uneven light.
// Source: flattening by a local mean and a local spread is the usual shading correction of images of engineering
// surfaces; the geometry of unrolling is that of a cylinder under a pinhole camera.
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/surface/grid.h"

namespace lathelier::surface {

/// The means of blocks, so that the picture has 1/`factor` of its pixels across, `factor` >= 1.
Grid reduced(const GridView& picture, double factor);

/// I / G(I) - 1 with G a Gaussian mean of σ = short side / 8, divided by its local root mean square (2 σ). Without a
/// unit; longer periods than about σ are gone.
Grid flattened(const Grid& picture, const Progress& progress = {});

/// How a cylinder lies in a picture.
struct Cylinder {
    double radius_px = 0;               ///< of the part
    double axis_deg = 0;                ///< direction of its axis in the picture, from x toward y
    Vector axis_point{};                ///< a point of the picture that its axis runs through
    std::optional<double> distance_px;  ///< of the camera from the axis; none: seen from far away
};

/// The largest angle about the axis that is unrolled to either side, in degrees: beyond, the surface is too oblique.
inline constexpr double mostUnrolled_deg = 50;

/// The surface with its circumference laid flat at the scale of the picture's middle: x along the axis direction, y
/// across it (turned with the axis: the picture is rotated by -axis_deg). With the camera at a distance d from the axis
/// v = (d - R) R sin φ / (d - R cos φ) and lengths along the axis shrink by (d - R) / (d - R cos φ).
Grid unrolled(const Grid& picture, const Cylinder& cylinder);

}  // namespace lathelier::surface
