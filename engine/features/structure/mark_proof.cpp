#include "engine/features/structure/mark_proof.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace lathelier::features {
namespace {

/// Do enough slices along one direction have their mean in the plane?
template <class Place>
bool isStraight(const std::vector<FloorPoint>& points, double sigma_mm, const Place& place)
{
    const auto less = [&](const FloorPoint& a, const FloorPoint& b) { return place(a) < place(b); };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    const double first = place(*low);
    const auto count = static_cast<std::size_t>((place(*high) - first) / proofThresholds.slice_mm) + 1;
    std::vector<double> sums(count, 0), numbers(count, 0);
    for (const FloorPoint& point : points) {
        const auto slice = static_cast<std::size_t>((place(point) - first) / proofThresholds.slice_mm);
        sums[slice] += point.off_mm;
        numbers[slice] += 1;
    }
    double judged = 0, off = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (numbers[i] < proofThresholds.slice_points) continue;
        judged += 1;
        const double limit =
            proofThresholds.slice_sigmas * sigma_mm / std::sqrt(numbers[i]) + proofThresholds.slice_mm_off;
        if (std::abs(sums[i] / numbers[i]) > limit) off += 1;
    }
    return judged >= proofThresholds.least_slices && off <= proofThresholds.most_slices_off * judged;
}

/// Is the parabola through the points along one direction significantly bent? Points further from the plane than noise
/// were left out, so the bottom of a pit passes the test of slices.
template <class Place>
bool isBent(const std::vector<FloorPoint>& points, double sigma_mm, const Place& place)
{
    const auto less = [&](const FloorPoint& a, const FloorPoint& b) { return place(a) < place(b); };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    const double middle = (place(*low) + place(*high)) / 2, half = (place(*high) - place(*low)) / 2;
    if (!(half > 0)) return false;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const FloorPoint& point : points) {
        const double x = (place(point) - middle) / half;
        const Eigen::Vector3d powers(1, x, x * x);
        normal += powers * powers.transpose();
        right += powers * point.off_mm;
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    const double bend_mm = solver.solve(right)[2];
    const double error_mm = sigma_mm * std::sqrt(std::max(0.0, solver.solve(Eigen::Vector3d::UnitZ())[2]));
    return std::abs(bend_mm) > proofThresholds.bend_sigmas * error_mm + proofThresholds.bend_mm;
}

}  // namespace

bool isPlane(const std::vector<FloorPoint>& points, double sigma_mm)
{
    if (points.empty()) return false;
    const auto along = [](const FloorPoint& p) { return p.z_mm; };
    const auto across = [](const FloorPoint& p) { return p.across_mm; };
    return isStraight(points, sigma_mm, along) && isStraight(points, sigma_mm, across) &&
           !isBent(points, sigma_mm, along) && !isBent(points, sigma_mm, across);
}

FloorShape floorShape(double radius_mm, double floor_mm, double width_mm, double limit_mm)
{
    const double seen_mm = radius_mm - limit_mm;
    if (!(seen_mm > floor_mm)) return FloorShape::Neither;
    const double chord = 2 * std::sqrt(seen_mm * seen_mm - floor_mm * floor_mm);
    if (std::abs(width_mm - chord) <= proofThresholds.chord_share * chord + proofThresholds.chord_mm)
        return FloorShape::Flat;
    return width_mm < proofThresholds.keyway_share * chord ? FloorShape::Keyway : FloorShape::Neither;
}

}  // namespace lathelier::features
