#include "engine/surface/preparation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/surface/picture_kernel.h"

namespace lathelier::surface {

Grid reduced(const GridView& picture, double factor)
{
    return pictureKernel().resized(picture, std::max(1, static_cast<int>(std::lround(picture.columns / factor))),
                                   std::max(1, static_cast<int>(std::lround(picture.rows / factor))));
}

Grid flattened(const Grid& picture, const Progress& progress)
{
    return pictureKernel().flattened(picture, progress);
}

Grid unrolled(const Grid& picture, const Cylinder& cylinder)
{
    const double radius = cylinder.radius_px;
    const double turn = cylinder.axis_deg * std::numbers::pi / 180;
    const Vector along{std::cos(turn), std::sin(turn)}, across{-std::sin(turn), std::cos(turn)};
    const double limit = mostUnrolled_deg * std::numbers::pi / 180;
    // v(φ), projected distance from the axis, and the foreshortening along the axis
    const auto shrink = [&](double phi) {
        const double d = cylinder.distance_px.value_or(0);
        return cylinder.distance_px ? (d - radius) / (d - radius * std::cos(phi)) : 1.0;
    };
    const auto seen = [&](double phi) { return radius * std::sin(phi) * shrink(phi); };
    // Extent of the picture along and across the axis from its corners.
    double low = 1e300, high = -1e300, left = 1e300, right = -1e300;
    for (const double x : {0.0, picture.columns - 1.0})
        for (const double y : {0.0, picture.rows - 1.0}) {
            const Vector from = Vector{x, y} - cylinder.axis_point;
            low = std::min(low, dot(from, across));
            high = std::max(high, dot(from, across));
            left = std::min(left, dot(from, along));
            right = std::max(right, dot(from, along));
        }
    const auto angleWithin = [&](double v) {  // largest φ projected within v
        const double sign = v < 0 ? -1 : 1;
        double inside = 0, outside = limit;
        if (std::abs(seen(limit)) <= std::abs(v)) return sign * limit;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (inside + outside);
            (std::abs(seen(middle)) <= std::abs(v) ? inside : outside) = middle;
        }
        return sign * inside;
    };
    const double from_phi = low < 0 ? angleWithin(low) : 0, to_phi = high > 0 ? angleWithin(high) : 0;
    const int rows = std::max(1, static_cast<int>(std::floor((to_phi - from_phi) * radius)) + 1);
    const int columns = std::max(1, static_cast<int>(std::floor(right - left)) + 1);
    std::vector<std::array<float, 2>> map;
    map.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    for (int row = 0; row < rows; ++row) {
        const double phi = from_phi + row / radius;
        const double v = seen(phi), scale = shrink(phi);
        for (int column = 0; column < columns; ++column) {
            const Vector place = cylinder.axis_point + scale * (left + column) * along + v * across;
            map.push_back({static_cast<float>(place.x), static_cast<float>(place.y)});
        }
    }
    return pictureKernel().remapped(picture, map, columns, rows);
}

}  // namespace lathelier::surface
