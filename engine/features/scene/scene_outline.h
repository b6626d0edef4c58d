// Largest radius of the surface of revolution about an axis, along z.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace lathelier::features {

/// Cells of (z, r) that are seen from enough directions; the outermost of each z is the outline.
class SceneOutline {
public:
    /// Points in the frame of the axis (z along it). `coverage_deg`: largest coverage of the circle along the part.
    SceneOutline(const std::vector<Eigen::Vector3d>& on_axis, double coverage_deg);

    /// How far outside the outline a point lies; 0: on it or inside. Beyond its ends along z.
    double beyond_mm(const Eigen::Vector3d& on_axis) const;
    /// Radius of the outline at this z, that of a millimetre about it included.
    double reach_mm(double z_mm) const;
    /// Is there no surface of revolution?
    bool isEmpty() const { return reach_mm_.empty(); }

private:
    double first_mm_ = 0, step_mm_ = 1;
    std::vector<double> reach_mm_;  ///< of each step along z, that of its neighbours included
};

}  // namespace lathelier::features
