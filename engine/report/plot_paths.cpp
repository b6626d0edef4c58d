#include "engine/report/plot_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lathelier::report {
namespace {

constexpr double farAway = 1e5;  ///< px: beyond every frame, small enough for exact differences

struct SheetPoint {
    double x;
    double y;
};

/// A contiguous section of a curve.
using Stretch = std::vector<SheetPoint>;

/// The line through the points, cut at the left and right edge of the frame.
std::vector<Stretch> stretches(const PlotFrame& frame, const std::vector<double>& x, const std::vector<double>& y)
{
    std::vector<Stretch> result;
    bool open = false, known = false;
    SheetPoint before{};
    const auto inside = [&](const SheetPoint& p) { return p.x >= frame.left && p.x <= frame.right; };
    const auto push = [&](const SheetPoint& p) {
        if (!open) result.emplace_back();
        open = true;
        result.back().push_back({p.x, std::clamp(p.y, frame.top, frame.bottom)});
    };
    const auto atEdge = [&](const SheetPoint& p, const SheetPoint& q) {  // intersection with the edge; p lies outside
        const double edge = p.x < frame.left ? frame.left : frame.right;
        return SheetPoint{edge, p.y + (edge - p.x) / (q.x - p.x) * (q.y - p.y)};
    };
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        const double px = frame.toX(x[i]);
        if (!isDrawable(x[i]) || !isDrawable(y[i]) || !isDrawable(px)) {
            open = known = false;
            continue;
        }
        const SheetPoint here{px, std::clamp(frame.toY(y[i]), -farAway, farAway)};
        const bool crosses =
            known && std::min(before.x, here.x) < frame.right && std::max(before.x, here.x) > frame.left;
        if (crosses && !inside(before)) push(atEdge(before, here));
        if (inside(here)) {
            push(here);
        } else {
            if (crosses) push(atEdge(here, before));
            open = false;
        }
        before = here;
        known = true;
    }
    return result;
}

/// Decimation: first, lowest, highest and last of consecutive points in one pixel column.
Stretch thinned(const Stretch& points)
{
    Stretch result;
    for (std::size_t begin = 0; begin < points.size();) {
        const double column = std::floor(points[begin].x);
        std::size_t low = begin;
        std::size_t high = begin;
        std::size_t end = begin;
        for (; end < points.size() && std::floor(points[end].x) == column; ++end) {
            if (points[end].y < points[low].y) low = end;
            if (points[end].y > points[high].y) high = end;
        }
        std::array<std::size_t, 4> kept{begin, std::min(low, high), std::max(low, high), end - 1};
        for (std::size_t k = 0; k < kept.size(); ++k)
            if (k == 0 || kept[k] != kept[k - 1]) result.push_back(points[kept[k]]);
        begin = end;
    }
    return result;
}

std::string moves(const Stretch& points, char first = 'M')
{
    std::string data;
    for (const SheetPoint& point : points) {
        data += data.empty() ? first : 'L';
        data += coordinate(point.x) + " " + coordinate(point.y);
    }
    return data;
}

/// The part of a polygon on one side of an edge (Sutherland and Hodgman); `above` is positive on that side.
template <class Above>
Stretch cut(const Stretch& polygon, const Above& above)
{
    Stretch result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const SheetPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double hp = above(p), hq = above(q);
        if (hp >= 0) result.push_back(p);
        if ((hp >= 0) != (hq >= 0)) {
            const double t = hp / (hp - hq);
            result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return result;
}

}  // namespace

std::size_t lengthOf(const Curve& curve)
{
    if (curve.style == Curve::Style::Bars) return std::min(curve.y.size(), curve.x.empty() ? 0 : curve.x.size() - 1);
    std::size_t count = std::min(curve.x.size(), curve.y.size());
    if (curve.style == Curve::Style::Band) count = std::min(count, curve.y_low.size());
    return count;
}

std::string discPath(double x, double y, double radius_px)
{
    return fmt::format("M{0} {1}a{2} {2} 0 1 0 {3} 0a{2} {2} 0 1 0 -{3} 0Z", coordinate(x - radius_px), coordinate(y),
                       coordinate(radius_px), coordinate(2 * radius_px));
}

std::string linePath(const PlotFrame& frame, const Curve& curve)
{
    std::string data;
    for (const Stretch& stretch : stretches(frame, curve.x, curve.y)) {
        data += moves(curve.along.empty() ? thinned(stretch) : stretch);
        if (stretch.size() == 1) data += "h0.01";
    }
    return data;
}

std::string pointsPath(const PlotFrame& frame, const Curve& curve, double radius_px)
{
    std::string data;
    for (const Stretch& stretch : stretches(frame, curve.x, curve.y))
        for (const SheetPoint& point : thinned(stretch)) data += discPath(point.x, point.y, radius_px);
    return data;
}

std::string bandPath(const PlotFrame& frame, const Curve& curve)
{
    // Both edges are broken at the same samples, so that they correspond after a gap.
    std::vector<double> high = curve.y;
    std::vector<double> low = curve.y_low;
    for (std::size_t i = 0; i < std::min(high.size(), low.size()); ++i)
        if (!isDrawable(high[i]) || !isDrawable(low[i])) high[i] = low[i] = NAN;
    const std::vector<Stretch> above = stretches(frame, curve.x, high);
    const std::vector<Stretch> below = stretches(frame, curve.x, low);
    std::string data;
    for (std::size_t i = 0; i < std::min(above.size(), below.size()); ++i) {
        Stretch back = thinned(below[i]);
        std::reverse(back.begin(), back.end());
        data += moves(thinned(above[i])) + moves(back, 'L') + "Z";
    }
    return data;
}

std::string barsPath(const PlotFrame& frame, const Curve& curve)
{
    std::string data;
    const double base = std::clamp(frame.toY(0), frame.top, frame.bottom);
    for (std::size_t i = 0; i < lengthOf(curve); ++i) {
        if (!isDrawable(curve.x[i]) || !isDrawable(curve.x[i + 1]) || !isDrawable(curve.y[i]) || curve.y[i] == 0)
            continue;
        const double left = std::clamp(frame.toX(curve.x[i]), frame.left, frame.right);
        const double right = std::clamp(frame.toX(curve.x[i + 1]), frame.left, frame.right);
        if (left == right) continue;
        const double top = std::clamp(frame.toY(curve.y[i]), frame.top, frame.bottom);
        data += fmt::format("M{} {}V{}H{}V{}Z", coordinate(left), coordinate(base), coordinate(top), coordinate(right),
                            coordinate(base));
    }
    return data;
}

std::string regionPath(const PlotFrame& frame, const Region& region)
{
    Stretch polygon;
    for (std::size_t i = 0; i < std::min(region.x.size(), region.y.size()); ++i) {
        if (std::isnan(region.x[i]) || std::isnan(region.y[i])) continue;
        const auto edged = [](double px, double value, double low, double high) {
            return std::isinf(value) ? (value < 0 ? low : high) : std::clamp(px, -farAway, farAway);
        };
        polygon.push_back({edged(frame.toX(region.x[i]), region.x[i], frame.left, frame.right),
                           edged(frame.toY(region.y[i]), region.y[i], frame.bottom, frame.top)});
    }
    polygon = cut(polygon, [&](const SheetPoint& p) { return p.x - frame.left; });
    polygon = cut(polygon, [&](const SheetPoint& p) { return frame.right - p.x; });
    polygon = cut(polygon, [&](const SheetPoint& p) { return p.y - frame.top; });
    polygon = cut(polygon, [&](const SheetPoint& p) { return frame.bottom - p.y; });
    return polygon.size() < 3 ? std::string() : moves(polygon) + "Z";
}

}  // namespace lathelier::report
