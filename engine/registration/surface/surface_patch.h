// A smooth piece of surface through the points of a small neighbourhood: z = quadric(x, y) in a frame of its own.
// Source: Cazals and Pouget, Comput. Aided Geom. Des. 22 (2005) 121-146 (osculating jets).
#pragma once

#include <Eigen/Core>
#include <span>

namespace lathelier::registration {

/// Height over the plane through `centre_mm` spanned by `u`, `v`: h = c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y².
struct SurfacePatch {
    Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();  ///< weighted mean of the points
    Eigen::Vector3d u = Eigen::Vector3d::UnitX();         ///< unit vector along which the points spread most: x
    Eigen::Vector3d v = Eigen::Vector3d::UnitY();         ///< unit vector across it: y
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();    ///< unit vector u × v, of either sense unless oriented
    Eigen::Matrix<double, 6, 1> c = Eigen::Matrix<double, 6, 1>::Zero();  ///< c0 in mm, c3…c5 in 1/mm and 0 for a plane
    double radius_mm = 0;                                                 ///< reach of the points it was made from
    double breadth = 0;   ///< across / along of those points: 0 on a line, 1 round
    double points = 0;    ///< sum of their weights
    double sigma_mm = 0;  ///< their scatter about it, allowing for its own degrees of freedom

    /// Distance of a point along the patch's normal at its foot, to second order in the slope.
    double distance_mm(const Eigen::Vector3d& point_mm) const;
    Eigen::Vector3d normalAt(const Eigen::Vector3d& point_mm) const;
    double lateral_mm(const Eigen::Vector3d& point_mm) const;  ///< from the centre, in the plane
    double slopeVariance(
        const Eigen::Vector3d& point_mm) const;  ///< of the normal there, for points spread over a disc
    void flip();

    /// Corrects for noise of `noise_mm` along the normal of a curved surface: noise outward spreads points over more
    /// area, so that the mean of a patch lies noise² (1/R1 + 1/R2) below the surface.
    void raise(double noise_mm) { c[0] -= 2 * noise_mm * noise_mm * (c[3] + c[5]); }
};

/// Fits a patch to at least 3 points with weights; a plane when they are too few or too unevenly spread for a quadric.
SurfacePatch fitPatch(std::span<const Eigen::Vector3d> points_mm, std::span<const double> weights);

/// The same with Tukey's weights about the last fit, starting from `start`; points further than 4.685 `sigma_mm` from
/// it have weight 0. Gives the number of points that count.
std::size_t fitRobustPatch(std::span<const Eigen::Vector3d> points_mm, double sigma_mm, int rounds,
                           SurfacePatch& patch);

}  // namespace lathelier::registration
