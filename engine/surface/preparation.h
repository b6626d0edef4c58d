// Preparation of a picture for its spectrum: region, reduction, unrolling, correction of uneven illumination. Source:
// flattening by a local mean and a local spread is the usual shading correction of images of engineering surfaces; the
// geometry of unrolling is that of a cylinder under a pinhole camera.
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/surface/grid.h"

namespace lathelier::surface {

/// The means of blocks, so that the picture has 1/`factor` of its pixels across, `factor` >= 1.
Grid reduced(const GridView& picture, double factor);

/// I / G(I) - 1 with G a Gaussian mean of σ = short side / 8, divided by its local root mean square (2 σ).
/// Dimensionless; periods longer than about σ are removed.
Grid flattened(const Grid& picture, const Progress& progress = {});

/// Pose of a cylinder in a picture.
struct Cylinder {
    double radius_px = 0;
    double axis_deg = 0;                ///< direction of its axis in the picture, from x toward y
    Vector axis_point{};                ///< a point of its axis in the picture
    std::optional<double> distance_px;  ///< of the camera from the axis; none: parallel projection
};

/// Largest angle about the axis that is unrolled to either side, in degrees; beyond, the view is too oblique.
inline constexpr double mostUnrolled_deg = 50;

/// The unrolled surface at the scale of the middle of the picture: x along the axis direction, y across it (turned with
/// the axis: the picture is rotated by -axis_deg). With the camera at a distance d from the axis v = (d - R) R sin φ /
/// (d - R cos φ) and lengths along the axis shrink by (d - R) / (d - R cos φ).
Grid unrolled(const Grid& picture, const Cylinder& cylinder);

}  // namespace lathelier::surface
