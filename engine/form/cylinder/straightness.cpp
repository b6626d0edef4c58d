#include "engine/form/cylinder/straightness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/form/circle/circle_enclosing.h"
#include "engine/form/cylinder/axis_frame.h"
#include "engine/form/linear_minimax.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Radius of the smallest cylinder about the points, whose axis is near z. Heights lie within -1…1. The distance
/// |(x, y) - c - z t| is convex in c and t, so each of its tangents bounds it from below everywhere (the tilt itself is
/// so small that its cosine is 1): tangents at the farthest points are added until bound and distance meet.
double smallestCylinder(const std::vector<Vector2d>& offset, const std::vector<double>& height)
{
    using Axis = Eigen::Vector4d;
    const auto difference = [&](const Axis& axis, std::size_t i) -> Vector2d {
        return offset[i] - axis.head<2>() - height[i] * axis.tail<2>();
    };
    LinearDistances<4> tangents;
    Axis axis = Axis::Zero(), best_axis = axis;
    double best = std::numeric_limits<double>::infinity(), half = 0;
    constexpr int mostRounds = 300;
    constexpr std::size_t tangentsARound = 6;
    std::vector<std::pair<double, std::size_t>> order(offset.size());
    for (int round = 0; round < mostRounds; ++round) {
        for (std::size_t i = 0; i < offset.size(); ++i) order[i] = {-difference(axis, i).norm(), i};
        const std::size_t count = std::min(tangentsARound, order.size());
        std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
        if (-order[0].first < best) {
            best = -order[0].first;
            best_axis = axis;
        }
        if (round == 0) half = 4 * best;
        if (!(best > 0)) break;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = order[k].second;
            const Vector2d d = difference(axis, i);
            const Vector2d e = d.norm() > 0 ? Vector2d(d.normalized()) : Vector2d::UnitX();
            Axis slope;
            slope << e, height[i] * e;
            tangents.push(e.dot(offset[i]), slope);
        }
        const MinimaxStep<4> plan = minimax<4>(tangents, MinimaxGoal::Farthest, half);
        if (plan.value >= best * (1 - 1e-9)) break;
        axis = 0.5 * (best_axis + plan.step);  // halved step: tangents far from the best axis are poor bounds near it
    }
    return best;
}

}  // namespace

StraightnessResult straightness(std::span<const Vector3d> points_mm)
{
    if (points_mm.size() < 2)
        throw Error(errors::tooFewPoints,
                    {{"found", static_cast<std::int64_t>(points_mm.size())}, {"minimum", std::int64_t{2}}});
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& point : points_mm) mean += (point - points_mm.front()) / static_cast<double>(points_mm.size());
    mean += points_mm.front();
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Vector3d& point : points_mm) moments += (point - mean) * (point - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
    if (!(axes.eigenvalues()[2] > 0))
        throw Error(errors::pointsDegenerate, {{"found", LT_TEXT("Engine", "in one place")}});

    StraightnessResult result;
    result.point_mm = mean;
    result.direction = towardPositive(axes.eigenvectors().col(2));
    const AxisFrame frame(result.direction);
    std::vector<Vector2d> offset;
    std::vector<double> height;
    double largest = 0, longest = 0;
    for (const Vector3d& point : points_mm) {
        const Vector3d local = frame.toLocal(point - mean);
        offset.emplace_back(local.x(), local.y());
        height.push_back(local.z());
        largest = std::max(largest, offset.back().norm());
        longest = std::max(longest, std::abs(local.z()));
    }
    for (double& h : height) h /= longest;
    constexpr double diameter_um = 2 * 1000;
    result.STRt_LSLI_um = diameter_um * largest;
    result.axis_straightness_um = diameter_um * enclosingCircle(offset).radius;
    // Narrower than the rounding of the coordinates: no improvement possible.
    result.STRt_MZLI_um = std::min(result.axis_straightness_um, diameter_um * smallestCylinder(offset, height));
    return result;
}

}  // namespace lathelier::form
