#include "engine/form/cylinder/cylinder_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/parallel.h"

namespace lathelier::form {
namespace {

constexpr Eigen::Index cylinderBlockSize = 512;
constexpr std::size_t cylinderPointsPerTask = 64 * cylinderBlockSize;

}  // namespace

CylinderPoints::CylinderPoints(std::span<const Eigen::Vector3d> points_mm, const Eigen::Vector3d& origin_mm,
                               const Eigen::Vector3d& direction, double scale_mm)
    : origin_mm_(origin_mm), frame_(direction), scale_mm_(scale_mm)
{
    const auto count = static_cast<Eigen::Index>(points_mm.size());
    x_.resize(count);
    y_.resize(count);
    z_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector3d local = frame_.toLocal(points_mm[static_cast<std::size_t>(i)] - origin_mm) / scale_mm;
        x_[i] = local.x();
        y_[i] = local.y();
        z_[i] = local.z();
    }
}

Eigen::Vector3d CylinderPoints::directionOf(const AxisParameters& axis) const
{
    return frame_.toWorld(Eigen::Vector3d(axis[2], axis[3], 1).normalized());
}

Eigen::Vector3d CylinderPoints::pointOf(const AxisParameters& axis) const
{
    const Eigen::Vector3d foot(axis[0], axis[1], 0), along(axis[2], axis[3], 1);
    const Eigen::Vector3d nearest = foot - along * (foot.dot(along) / along.squaredNorm());
    return origin_mm_ + scale_mm_ * frame_.toWorld(nearest);
}

CylinderPoints::Extremes CylinderPoints::extremes(const AxisParameters& axis, const Progress& progress) const
{
    using Block = Eigen::Array<double, cylinderBlockSize, 1>;
    const double shortening = 1 / (1 + axis.tail<2>().squaredNorm());
    // w is the offset from the axis at the point's height; its component along the tilt of the axis is reduced.
    const auto squares = [&](Eigen::Index begin, Eigen::Index n, Block& wx, Block& wy, Block& result) {
        wx.head(n) = x_.segment(begin, n) - axis[0] - z_.segment(begin, n) * axis[2];
        wy.head(n) = y_.segment(begin, n) - axis[1] - z_.segment(begin, n) * axis[3];
        result.head(n) = wx.head(n).square() + wy.head(n).square() -
                         shortening * (wx.head(n) * axis[2] + wy.head(n) * axis[3]).square();
    };
    struct Part {
        double low = std::numeric_limits<double>::infinity(), high = -1;
        Eigen::Index low_block = 0, high_block = 0;
    };
    const Part all = parallelReduce(
        size(), cylinderPointsPerTask, progress, Part{},
        [&](std::size_t begin, std::size_t end) {
            Part part;
            Block wx, wy, d;
            for (auto block = static_cast<Eigen::Index>(begin); block < static_cast<Eigen::Index>(end);
                 block += cylinderBlockSize) {
                const Eigen::Index n = std::min(cylinderBlockSize, static_cast<Eigen::Index>(end) - block);
                squares(block, n, wx, wy, d);
                if (const double low = d.head(n).minCoeff(); low < part.low) {
                    part.low = low;
                    part.low_block = block;
                }
                if (const double high = d.head(n).maxCoeff(); high > part.high) {
                    part.high = high;
                    part.high_block = block;
                }
            }
            return part;
        },
        [](Part a, const Part& b) {
            if (b.low < a.low) {
                a.low = b.low;
                a.low_block = b.low_block;
            }
            if (b.high > a.high) {
                a.high = b.high;
                a.high_block = b.high_block;
            }
            return a;
        });
    Block wx, wy, d;
    const auto find = [&](Eigen::Index block, double value) {
        const Eigen::Index n = std::min(cylinderBlockSize, x_.size() - block);
        squares(block, n, wx, wy, d);
        Eigen::Index i = 0;
        while (i + 1 < n && d[i] != value) ++i;
        return static_cast<std::size_t>(block + i);
    };
    return {std::sqrt(std::max(all.low, 0.0)), std::sqrt(std::max(all.high, 0.0)), find(all.low_block, all.low),
            find(all.high_block, all.high)};
}

AxisDistance distanceFrom(const AxisParameters& axis, const Eigen::Vector3d& point)
{
    const double tx = axis[2], ty = axis[3], z = point.z();
    const double wx = point.x() - axis[0] - z * tx, wy = point.y() - axis[1] - z * ty;
    const double k = 1 / (1 + tx * tx + ty * ty), m = wx * tx + wy * ty;
    AxisDistance result;
    result.distance = std::sqrt(std::max(wx * wx + wy * wy - k * m * m, 0.0));
    if (!(result.distance > 0)) return result;
    result.gradient << -wx + k * m * tx, -wy + k * m * ty, -z * wx - k * m * (wx - z * tx) + k * k * m * m * tx,
        -z * wy - k * m * (wy - z * ty) + k * k * m * m * ty;
    result.gradient /= result.distance;
    return result;
}

}  // namespace lathelier::form
