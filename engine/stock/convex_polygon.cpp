#include "engine/stock/convex_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::stock {
namespace {

/// The part of a polygon to the left of the line through `at` along `direction`, which has length 1.
ConvexPolygon leftOf(const ConvexPolygon& polygon, const Corner& at, const Corner& direction)
{
    ConvexPolygon kept;
    kept.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& one = polygon[i];
        const Corner& next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double here = cross(direction, one - at), there = cross(direction, next - at);
        if (here >= 0) kept.push_back(one);
        if ((here < 0 && there > 0) || (here > 0 && there < 0))
            kept.push_back(one + here / (here - there) * (next - one));
    }
    if (kept.size() < 3) kept.clear();
    return kept;
}

/// The part common to the half planes to the left of the edges of `frame`, each moved inward by `inward_mm`.
ConvexPolygon clipped(ConvexPolygon polygon, const ConvexPolygon& frame, double inward_mm)
{
    for (std::size_t i = 0; i < frame.size() && !polygon.empty(); ++i) {
        const Corner edge = frame[i + 1 < frame.size() ? i + 1 : 0] - frame[i];
        const double length = length_mm(edge);
        if (!(length > 0)) continue;
        const Corner along = 1 / length * edge;
        polygon = leftOf(polygon, frame[i] + inward_mm * Corner{-along.x_mm, along.z_mm}, along);
    }
    return polygon;
}

}  // namespace

double length_mm(const Corner& displacement)
{
    return std::hypot(displacement.z_mm, displacement.x_mm);
}

Box boxOf(const ConvexPolygon& polygon)
{
    if (polygon.empty()) return {};
    Box box{polygon.front(), polygon.front()};
    for (const Corner& corner : polygon) {
        box.low = {std::min(box.low.z_mm, corner.z_mm), std::min(box.low.x_mm, corner.x_mm)};
        box.high = {std::max(box.high.z_mm, corner.z_mm), std::max(box.high.x_mm, corner.x_mm)};
    }
    return box;
}

ConvexPolygon hullOf(std::vector<Corner> corners)
{
    std::sort(corners.begin(), corners.end(),
              [](const Corner& a, const Corner& b) { return a.z_mm != b.z_mm ? a.z_mm < b.z_mm : a.x_mm < b.x_mm; });
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (corners.size() < 3) return {};
    ConvexPolygon hull;
    const auto add = [&hull](const Corner& corner, std::size_t first) {
        while (hull.size() >= first + 2 &&
               cross(hull.back() - hull[hull.size() - 2], corner - hull[hull.size() - 2]) <= 0)
            hull.pop_back();
        hull.push_back(corner);
    };
    for (const Corner& corner : corners) add(corner, 0);
    const std::size_t right = hull.size() - 1;
    for (auto corner = corners.rbegin() + 1; corner != corners.rend(); ++corner) add(*corner, right);
    hull.pop_back();
    if (hull.size() < 3) hull.clear();
    return hull;
}

ConvexPolygon movedBy(const ConvexPolygon& polygon, const Corner& by)
{
    ConvexPolygon moved = polygon;
    for (Corner& corner : moved) corner = corner + by;
    return moved;
}

ConvexPolygon sweptBy(const ConvexPolygon& polygon, const Corner& by)
{
    const std::size_t count = polygon.size();
    if (count < 3) return {};
    ConvexPolygon swept;
    swept.reserve(count + 2);
    const auto facesForward = [&](std::size_t i) {
        return cross(by, polygon[i + 1 < count ? i + 1 : 0] - polygon[i]) > 0;
    };
    bool before = facesForward(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const bool after = facesForward(i);
        swept.push_back(before ? polygon[i] + by : polygon[i]);
        if (after != before) swept.push_back(after ? polygon[i] + by : polygon[i]);
        before = after;
    }
    return swept;
}

ConvexPolygon grownBy(const ConvexPolygon& polygon, double distance_mm)
{
    // An octagon of apothem 1 is the sum of four segments of half length 1/(1 + √2).
    const double half_mm = distance_mm / (1 + std::numbers::sqrt2);
    ConvexPolygon grown = polygon;
    for (const int eighth : {0, 1, 2, 3}) {
        const double angle = eighth * std::numbers::pi / 4;
        const Corner half{half_mm * std::cos(angle), half_mm * std::sin(angle)};
        grown = sweptBy(movedBy(grown, -1 * half), 2 * half);
    }
    return grown;
}

ConvexPolygon shrunkBy(const ConvexPolygon& polygon, double distance_mm)
{
    return clipped(polygon, polygon, distance_mm);
}

ConvexPolygon overlapOf(const ConvexPolygon& a, const ConvexPolygon& b)
{
    if (a.size() < 3 || b.size() < 3) return {};
    return clipped(a, b, 0);
}

}  // namespace lathelier::stock
