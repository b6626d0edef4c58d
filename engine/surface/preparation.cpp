#include "engine/surface/preparation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace lathelier::surface {
namespace {

cv::Mat viewOf(const Grid& grid)
{
    return {grid.rows, grid.columns, CV_32F, const_cast<float*>(grid.values.data())};
}

/// A Gaussian mean of any width in the time of a narrow one: on means of blocks, interpolated back.
cv::Mat wideMean(const cv::Mat& picture, double sigma)
{
    const double factor = std::max(1.0, std::floor(sigma / 6));
    cv::Mat small, mean;
    const cv::Size size(std::max(2, static_cast<int>(std::lround(picture.cols / factor))),
                        std::max(2, static_cast<int>(std::lround(picture.rows / factor))));
    cv::resize(picture, small, size, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(small, small, {}, sigma / factor, sigma / factor, cv::BORDER_REFLECT);
    cv::resize(small, mean, picture.size(), 0, 0, cv::INTER_LINEAR);
    return mean;
}

}  // namespace

Grid reduced(const GridView& picture, double factor)
{
    Grid small(std::max(1, static_cast<int>(std::lround(picture.columns / factor))),
               std::max(1, static_cast<int>(std::lround(picture.rows / factor))));
    cv::Mat out = viewOf(small);
    const cv::Mat source(picture.rows, picture.columns, CV_32F, const_cast<float*>(picture.first),
                         static_cast<std::size_t>(picture.stride) * sizeof(float));
    cv::resize(source, out, out.size(), 0, 0, cv::INTER_AREA);
    return small;
}

Grid flattened(const Grid& picture, const Progress& progress)
{
    const double sigma = std::min(picture.columns, picture.rows) / 8.0;
    const cv::Mat source = viewOf(picture);
    constexpr double darkest = 1e-4;  // of full scale: no division by black
    Grid result(picture.columns, picture.rows);
    cv::Mat flat = viewOf(result);
    cv::Mat ratio;
    cv::divide(source, cv::max(wideMean(source, sigma), darkest), ratio);
    cv::subtract(ratio, 1.0, flat);
    progress.report(0.5);
    cv::Mat spread;
    cv::sqrt(cv::max(wideMean(flat.mul(flat), 2 * sigma), 1e-12), spread);
    cv::divide(flat, spread, flat);
    progress.report(1);
    return result;
}

Grid unrolled(const Grid& picture, const Cylinder& cylinder)
{
    const double radius = cylinder.radius_px;
    const double turn = cylinder.axis_deg * std::numbers::pi / 180;
    const Vector along{std::cos(turn), std::sin(turn)}, across{-std::sin(turn), std::cos(turn)};
    const double limit = mostUnrolled_deg * std::numbers::pi / 180;
    // v(φ), its distance from the axis as the picture shows it, and the shrinking along the axis
    const auto shrink = [&](double phi) {
        const double d = cylinder.distance_px.value_or(0);
        return cylinder.distance_px ? (d - radius) / (d - radius * std::cos(phi)) : 1.0;
    };
    const auto seen = [&](double phi) { return radius * std::sin(phi) * shrink(phi); };
    // The corners tell how far the picture reaches along and across the axis.
    double low = 1e300, high = -1e300, left = 1e300, right = -1e300;
    for (const double x : {0.0, picture.columns - 1.0})
        for (const double y : {0.0, picture.rows - 1.0}) {
            const Vector from = Vector{x, y} - cylinder.axis_point;
            low = std::min(low, dot(from, across));
            high = std::max(high, dot(from, across));
            left = std::min(left, dot(from, along));
            right = std::max(right, dot(from, along));
        }
    const auto angleWithin = [&](double v) {  // the largest φ whose place is not beyond v
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
    cv::Mat map(rows, columns, CV_32FC2);
    for (int row = 0; row < rows; ++row) {
        const double phi = from_phi + row / radius;
        const double v = seen(phi), scale = shrink(phi);
        auto* line = map.ptr<cv::Vec2f>(row);
        for (int column = 0; column < columns; ++column) {
            const Vector place = cylinder.axis_point + scale * (left + column) * along + v * across;
            line[column] = {static_cast<float>(place.x), static_cast<float>(place.y)};
        }
    }
    Grid result(columns, rows);
    cv::Mat out = viewOf(result);
    cv::remap(viewOf(picture), out, map, cv::noArray(), cv::INTER_LANCZOS4, cv::BORDER_REPLICATE);
    return result;
}

}  // namespace lathelier::surface
