#include "engine/form/circle/two_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/form/circle/plane_cross.h"
#include "engine/signal/closed_interpolation.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The hull's next corner on the way anticlockwise; corners at which the path turns right are removed.
void add(std::vector<Vector2d>& hull, std::size_t start, const Vector2d& point)
{
    while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
        hull.pop_back();
    hull.push_back(point);
}

/// Whether the points are in anticlockwise order about their centroid with steps below a quarter turn; backward steps
/// up to 1e-12 rad are rounding.
bool goesRound(std::span<const Vector2d> points)
{
    Vector2d centroid = Vector2d::Zero();
    for (const Vector2d& point : points) centroid += point / static_cast<double>(points.size());
    std::size_t turns = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector2d from = points[i] - centroid, to = points[(i + 1) % points.size()] - centroid;
        if (!(cross(from, to) > -1e-12 * from.squaredNorm()) || !(from.dot(to) > 0)) return false;
        turns += from.y() < 0 && to.y() >= 0;
    }
    return turns == 1;
}

/// Corners of the convex hull, anticlockwise: in the order of the points where that is angular (Graham 1972), else
/// sorted (Andrew's monotone chain).
std::vector<Vector2d> convexHull(std::span<const Vector2d> points)
{
    std::vector<Vector2d> hull;
    const auto less = [](const Vector2d& a, const Vector2d& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    if (goesRound(points)) {
        const auto first = std::min_element(points.begin(), points.end(), less);  // certainly a hull vertex
        for (auto it = first; it != points.end(); ++it) add(hull, 0, *it);
        for (auto it = points.begin(); it <= first; ++it) add(hull, 0, *it);
        hull.pop_back();  // duplicate of the first
        return hull;
    }
    std::vector<Vector2d> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(), less);
    const auto chain = [&](auto begin, auto end) {
        const std::size_t start = hull.size();
        for (auto it = begin; it != end; ++it) add(hull, start, *it);
        hull.pop_back();  // first vertex of the other chain
    };
    chain(sorted.begin(), sorted.end());
    chain(sorted.rbegin(), sorted.rend());
    return hull;
}

}  // namespace

TwoPointSize twoPointSize(std::span<const Vector2d> points_mm, const signal::AngularSampling& sampling,
                          const Vector2d& centre_mm, const Progress& progress)
{
    std::vector<double> distance;
    distance.reserve(points_mm.size());
    for (const Vector2d& point : points_mm) distance.push_back((point - centre_mm).norm());
    const signal::ClosedInterpolation profile(sampling, distance);
    TwoPointSize result;
    struct Sizes {
        double largest_mm = -infinity, smallest_mm = infinity;
        std::size_t missing = 0;
    };
    const Sizes sizes = parallelReduce(
        distance.size(), 8192, progress, Sizes(),
        [&](std::size_t begin, std::size_t end) {
            Sizes part;
            std::size_t place = (begin + distance.size() / 2) % distance.size();  // approximate index of the opposite
                                                                                  // point
            for (std::size_t i = begin; i < end; ++i) {
                const double size = distance[i] + profile(sampling.angle_rad[i] + std::numbers::pi, place);
                if (size > part.largest_mm) part.largest_mm = size;  // false for NaN (no opposite point)
                if (size < part.smallest_mm) part.smallest_mm = size;
                part.missing += std::isnan(size);
            }
            return part;
        },
        [](const Sizes& all, const Sizes& part) {
            return Sizes{std::max(all.largest_mm, part.largest_mm), std::min(all.smallest_mm, part.smallest_mm),
                         all.missing + part.missing};
        });
    // Interpolated noise may exceed the bound slightly; sizes between measured points cannot.
    const auto [nearest, farthest] = std::minmax_element(distance.begin(), distance.end());
    if (std::isfinite(sizes.largest_mm)) {
        result.largest_mm = std::min(sizes.largest_mm, 2 * *farthest);
        result.smallest_mm = std::max(sizes.smallest_mm, 2 * *nearest);
    } else {
        result.largest_mm = result.smallest_mm = notANumber;
    }
    result.range_um = um_per_mm * (result.largest_mm - result.smallest_mm);
    result.half_range_um = result.range_um / 2;
    result.without_opposite = sizes.missing;
    const CaliperWidth width = caliperWidth(points_mm);
    result.caliper_largest_mm = width.largest_mm;
    result.caliper_smallest_mm = width.smallest_mm;
    return result;
}

CaliperWidth caliperWidth(std::span<const Vector2d> points_mm)
{
    const std::vector<Vector2d> hull = convexHull(points_mm);
    const std::size_t n = hull.size();
    CaliperWidth width{0, std::numeric_limits<double>::infinity()};
    if (n < 3) return {};
    std::size_t far = 1;
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2d edge = hull[(i + 1) % n] - hull[i];
        const auto height = [&](std::size_t j) { return cross(edge, hull[j % n] - hull[i]); };
        while (height(far + 1) > height(far)) ++far;
        width.smallest_mm = std::min(width.smallest_mm, height(far) / edge.norm());
        // The farthest vertices of both edges enumerate all antipodal pairs.
        for (const std::size_t j : {far, far + 1})
            for (const std::size_t k : {i, i + 1})
                width.largest_mm = std::max(width.largest_mm, (hull[j % n] - hull[k % n]).norm());
    }
    return width;
}

}  // namespace lathelier::form
