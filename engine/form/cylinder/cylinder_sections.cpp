#include "engine/form/cylinder/cylinder_sections.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/error.h"
#include "engine/form/circle/circles.h"
#include "engine/form/cylinder/axis_frame.h"

namespace lathelier::form {

SectionStack sectionsAlong(std::span<const Eigen::Vector3d> points_mm, const Eigen::Vector3d& axis_point_mm,
                           const Eigen::Vector3d& axis_direction, const Progress& progress)
{
    constexpr std::size_t leastPoints = 8;
    constexpr double sameHeight_mm = 1e-6;  // files round to more
    const AxisFrame frame(axis_direction);
    Eigen::Index across = 0;
    axis_direction.cwiseAbs().maxCoeff(&across);
    SectionStack stack;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::vector<std::pair<double, std::size_t>> heights(points_mm.size());
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        const double along = axis_direction.dot(points_mm[i] - axis_point_mm);
        low = std::min(low, along);
        high = std::max(high, along);
        heights[i] = {points_mm[i][across], i};
    }
    stack.length_mm = high - low;
    progress.check();
    std::sort(heights.begin(), heights.end());
    progress.check();

    std::vector<Eigen::Vector2d> section;
    for (std::size_t begin = 0, end = 0; begin < heights.size(); begin = end) {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        section.clear();
        while (end < heights.size() && heights[end].first - heights[begin].first <= sameHeight_mm) {
            const Eigen::Vector3d local = frame.toLocal(points_mm[heights[end++].second] - axis_point_mm);
            section.emplace_back(local.head<2>());
            mean += local;
        }
        if (section.size() < leastPoints) {
            stack.centres_mm.clear();
            return stack;
        }
        progress.check();
        try {
            const Eigen::Vector2d centre = fitLeastSquaresCircle(section).centre_mm;
            const double height = mean.z() / static_cast<double>(section.size());
            stack.centres_mm.push_back(axis_point_mm + frame.toWorld({centre.x(), centre.y(), height}));
        } catch (const Error&) {  // a section is not a circle: the points are not a stack of sections
            stack.centres_mm.clear();
            return stack;
        }
    }
    return stack;
}

}  // namespace lathelier::form
