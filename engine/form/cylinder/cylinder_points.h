// The points of a cylinder in coordinates along a first guess of its axis, for the fits that refine it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "engine/core/progress.h"
#include "engine/form/cylinder/axis_frame.h"

namespace lathelier::form {

/// An axis near z: through (x0, y0, 0) along (tx, ty, 1).
using AxisParameters = Eigen::Vector4d;

class CylinderPoints {
public:
    /// `origin_mm` becomes 0, `direction` z, and `scale_mm` the unit of length.
    CylinderPoints(std::span<const Eigen::Vector3d> points_mm, const Eigen::Vector3d& origin_mm,
                   const Eigen::Vector3d& direction, double scale_mm);

    std::size_t size() const { return static_cast<std::size_t>(x_.size()); }
    double scale_mm() const { return scale_mm_; }
    Eigen::Vector3d point(std::size_t index) const
    {
        const auto i = static_cast<Eigen::Index>(index);
        return {x_[i], y_[i], z_[i]};
    }
    double lowest() const { return z_.minCoeff(); }
    double highest() const { return z_.maxCoeff(); }

    /// Of the axis, in the input coordinates; the point is the one nearest to the given origin.
    Eigen::Vector3d directionOf(const AxisParameters& axis) const;
    Eigen::Vector3d pointOf(const AxisParameters& axis) const;

    struct Extremes {
        double nearest = 0, farthest = 0;  ///< distances from the axis, in the unit of length of the class
        std::size_t nearest_index = 0, farthest_index = 0;  ///< places of the points that have these distances

        double width() const { return farthest - nearest; }
    };
    Extremes extremes(const AxisParameters& axis, const Progress& progress) const;

private:
    Eigen::ArrayXd x_, y_, z_;
    Eigen::Vector3d origin_mm_;
    AxisFrame frame_;
    double scale_mm_;
};

/// Distance of a point from an axis, and how it changes with the axis' parameters.
struct AxisDistance {
    double distance = 0;                                 ///< from the axis, in the unit of length of the class
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();  ///< derivatives by x0, y0, tx, ty; 0 on the axis
};
AxisDistance distanceFrom(const AxisParameters& axis, const Eigen::Vector3d& point);

}  // namespace lathelier::form
