// Directions of axes, and coordinates about them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace lathelier::form {

/// The direction with the sign that makes its largest coordinate positive.
inline Eigen::Vector3d towardPositive(const Eigen::Vector3d& direction)
{
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    return direction[largest] < 0 ? Eigen::Vector3d(-direction) : direction;
}

/// Right-handed frame whose z axis is the given axis.
struct AxisFrame {
    Eigen::Matrix3d local_R_world;

    explicit AxisFrame(const Eigen::Vector3d& axis)
    {
        Eigen::Index smallest = 0;
        axis.cwiseAbs().minCoeff(&smallest);
        const Eigen::Vector3d x = axis.cross(Eigen::Vector3d::Unit(smallest)).normalized();
        local_R_world << x.transpose(), axis.cross(x).transpose(), axis.transpose();
    }
    Eigen::Vector3d toLocal(const Eigen::Vector3d& v) const { return local_R_world * v; }
    Eigen::Vector3d toWorld(const Eigen::Vector3d& v) const { return local_R_world.transpose() * v; }
};

}  // namespace lathelier::form
