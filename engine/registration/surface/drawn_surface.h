// The surface of a drawn body of revolution: exact distance to its meridian, at a cost that follows the rows of the
// drawing and not their size. A mesh of a large flat cone has thousands of facets at the same distance from its axis.
#pragma once

#include "engine/registration/surface/surface.h"
#include "engine/shaft/contour_distance.h"

namespace lathelier::registration {

class DrawnSurface : public Surface {
public:
    /// `meridian` as closedContour() gives it; `middle_mm`: origin of the queries in its frame.
    DrawnSurface(const Contour& meridian, const Eigen::Vector3d& middle_mm);

    void place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm, std::span<SurfacePlace> places,
               std::span<Trace> traces) const override;
    bool orient(const Progress&) override { return true; }  // a closed meridian
    double scatter_mm() const override { return 0; }
    std::size_t pointCount() const override { return 0; }
    const Neighbours* points() const override { return nullptr; }
    double spacing_mm() const override { return 0; }

private:
    ContourDistance distance_;
    Eigen::Vector3d middle_mm_;
};

/// Of a point (x, y, z), z along the axis, within reach of `distance`: signed distance and direction; else not found.
SurfacePlace placeOn(const ContourDistance& distance, const Eigen::Vector3d& point_mm);

}  // namespace lathelier::registration
