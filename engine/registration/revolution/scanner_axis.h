// Axis of a rotary scanner, from the order and the coordinates of its points.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace lathelier::registration {

/// Standard uncertainty of the distance between the axes of scanner and part where it cannot be estimated, as a share
/// of the radius: by judgement, a part stands near the middle of a turntable.
inline constexpr double axisOffsetShare = 0.15;

/// The axis of a scanner whose rays run across it and toward it, and whose rows lie across it.
struct ScannerAxis {
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();    ///< on the axis, in the frame of the part's axis
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector in that frame
    double sigma_mm = 0;                                   ///< standard uncertainty of the place across the direction

    /// Unit vector from the scanner's axis along the ray that made `point`.
    Eigen::Vector3d outward(const Eigen::Vector3d& point) const
    {
        const Eigen::Vector3d arm = point - point_mm;
        return (arm - direction * direction.dot(arm)).normalized();
    }
};

/// The axis of the scanner in the frame of `axis_T_scan` (the part's axis is z), for points that come row by row:
/// neighbours in a row lie in one plane across the axis and one step of angle apart. Where the plane is found but no
/// step of angle, the axis is taken to meet the part's at its origin, uncertain by axisOffsetShare times
/// `radius_mm`.
/// nullopt when the points do not come in rows, or when the rows lie more than 60° from across the part's axis.
std::optional<ScannerAxis> findScannerAxis(const std::vector<Eigen::Vector3d>& points,
                                           const Eigen::Isometry3d& axis_T_scan, double radius_mm);

}  // namespace lathelier::registration
