#include "engine/stock/stock_outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/units.h"

namespace lathelier::stock {
namespace {

constexpr std::size_t noEdge = static_cast<std::size_t>(-1);

/// Successor of a span edge: an edge in a neighbouring column, or the other edge of the end in the same column.
struct Link {
    std::size_t to = noEdge;
    double end_mm = 0;  ///< z of the end face
    bool turns_back = false;
};

/// Edges are numbered 2·span for the lower one and 2·span + 1 for the upper one. With material to the left, a lower
/// edge runs toward the chuck and an upper one toward the free end.
class Boundary {
public:
    explicit Boundary(const MeridianStock& stock)
    {
        first_.reserve(stock.columns() + 1);
        spans_.reserve(stock.columns());
        z_mm_.reserve(stock.columns());
        for (std::size_t i = 0; i < stock.columns(); ++i) {
            first_.push_back(spans_.size());
            stock.appendSpans(i, spans_);
            z_mm_.resize(spans_.size(), stock.middle_mm(i));
        }
        first_.push_back(spans_.size());
        links_.resize(2 * spans_.size());
        const double half_mm = stock.step_mm() / 2;
        for (std::size_t i = 0; i <= stock.columns(); ++i) {
            const auto left = i > 0 ? columnOf(i - 1) : std::pair<std::size_t, std::size_t>{0, 0};
            const auto right = i < stock.columns() ? columnOf(i) : std::pair<std::size_t, std::size_t>{0, 0};
            linkColumns(left, right, static_cast<double>(i) * 2 * half_mm);
        }
    }

    std::vector<std::vector<Corner>> loops() const
    {
        std::vector<std::vector<Corner>> result;
        std::vector<bool> is_seen(links_.size(), false);
        for (std::size_t start = 0; start < links_.size(); ++start) {
            if (is_seen[start]) continue;
            std::vector<Corner>& loop = result.emplace_back();
            for (std::size_t edge = start; !is_seen[edge]; edge = links_[edge].to) {
                is_seen[edge] = true;
                append(loop, cornerOf(edge));
                const Link& link = links_[edge];
                if (!link.turns_back) continue;
                append(loop, {link.end_mm, cornerOf(edge).x_mm});
                append(loop, {link.end_mm, cornerOf(link.to).x_mm});
            }
            loop.push_back(loop.front());
        }
        return result;
    }

private:
    using Range = std::pair<std::size_t, std::size_t>;
    Range columnOf(std::size_t i) const { return {first_[i], first_[i + 1]}; }

    Corner cornerOf(std::size_t edge) const
    {
        const RadialSpan& span = spans_[edge / 2];
        return {z_mm_[edge / 2], edge % 2 == 0 ? span.low_mm : span.high_mm};
    }

    /// Drops collinear corners of equal radius (cylinders).
    static void append(std::vector<Corner>& loop, const Corner& corner)
    {
        const std::size_t count = loop.size();
        const bool is_collinear = count > 1 && loop[count - 1].x_mm == corner.x_mm &&
                                  loop[count - 2].x_mm == corner.x_mm &&
                                  (loop[count - 1].z_mm > loop[count - 2].z_mm) == (corner.z_mm > loop[count - 1].z_mm);
        if (is_collinear)
            loop.back() = corner;
        else
            loop.push_back(corner);
    }

    bool meet(std::size_t a, std::size_t b) const
    {
        return spans_[a].low_mm < spans_[b].high_mm && spans_[b].low_mm < spans_[a].high_mm;
    }

    /// Lower edges go on to the right column, upper ones to the left one. With both columns traversed outward,
    /// overlapping spans form groups; within a group the gaps between the spans of one column are closed.
    void linkColumns(Range left, Range right, double border_mm)
    {
        std::size_t a = left.first, b = right.first;
        while (a < left.second || b < right.second) {
            if (b == right.second || (a < left.second && spans_[a].high_mm <= spans_[b].low_mm)) {
                links_[2 * a] = {2 * a + 1, border_mm, true};
                ++a;
                continue;
            }
            if (a == left.second || spans_[b].high_mm <= spans_[a].low_mm) {
                links_[2 * b + 1] = {2 * b, border_mm, true};
                ++b;
                continue;
            }
            links_[2 * a] = {2 * b};
            for (;;) {
                if (a + 1 < left.second && meet(a + 1, b)) {
                    links_[2 * (a + 1)] = {2 * a + 1, border_mm, true};
                    ++a;
                } else if (b + 1 < right.second && meet(a, b + 1)) {
                    links_[2 * b + 1] = {2 * (b + 1), border_mm, true};
                    ++b;
                } else {
                    break;
                }
            }
            links_[2 * b + 1] = {2 * a + 1};
            ++a;
            ++b;
        }
    }

    std::vector<RadialSpan> spans_;
    std::vector<double> z_mm_;        // of each span
    std::vector<std::size_t> first_;  // span of each column
    std::vector<Link> links_;         // of each edge
};

double squaredLength(const Corner& a)
{
    return a.z_mm * a.z_mm + a.x_mm * a.x_mm;
}

/// Squared distance of a point from the line between two others.
double squaredDistance(const Corner& point, const Corner& a, const Corner& b)
{
    const Corner along = b - a, beside = point - a;
    const double length2 = squaredLength(along);
    if (!(length2 > 0)) return squaredLength(beside);
    const double share = (beside.z_mm * along.z_mm + beside.x_mm * along.x_mm) / length2;
    return squaredLength(beside - std::clamp(share, 0.0, 1.0) * along);
}

/// Leaves out corners in one pass: from the last one kept, all that follow are seen within a wedge that each narrows to
/// the directions that pass it within the tolerance (J. Sklansky, V. Gonzalez, "Fast polygonal approximation of
/// digitized curves", 1980). O(corners), while halving costs their square where it splits off few.
std::vector<Corner> thinned(const std::vector<Corner>& loop, double tolerance_mm)
{
    std::vector<Corner> result{loop.front()};
    Corner low, high;  // the wedge, anticlockwise from low to high
    bool is_wedge = false;
    double reach_mm = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
        Corner way = loop[i] - result.back();
        double length = length_mm(way);
        const bool is_passed = is_wedge && (cross(low, way) < 0 || cross(way, high) < 0);
        if (length < reach_mm || is_passed) {
            result.push_back(loop[i - 1]);
            way = loop[i] - result.back();
            length = length_mm(way);
            is_wedge = false;
        }
        reach_mm = length;
        if (length <= tolerance_mm) continue;
        const double sine = tolerance_mm / length, cosine = std::sqrt(1 - sine * sine);
        const Corner right{cosine * way.z_mm + sine * way.x_mm, cosine * way.x_mm - sine * way.z_mm};
        const Corner left{cosine * way.z_mm - sine * way.x_mm, cosine * way.x_mm + sine * way.z_mm};
        if (!is_wedge || cross(low, right) > 0) low = right;
        if (!is_wedge || cross(left, high) > 0) high = left;
        is_wedge = true;
    }
    result.push_back(loop.back());
    return result;
}

std::vector<Corner> simplified(const std::vector<Corner>& all, double whole_tolerance_mm)
{
    constexpr double first_share = 0.25;
    const std::vector<Corner> loop = thinned(all, first_share * whole_tolerance_mm);
    const double tolerance_mm = (1 - first_share) * whole_tolerance_mm;
    std::vector<bool> is_kept(loop.size(), false);
    is_kept.front() = is_kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, loop.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double farthest2 = tolerance_mm * tolerance_mm;
        std::size_t split = from;
        for (std::size_t i = from + 1; i < to; ++i)
            if (const double d2 = squaredDistance(loop[i], loop[from], loop[to]); d2 > farthest2) {
                farthest2 = d2;
                split = i;
            }
        if (split == from) continue;
        is_kept[split] = true;
        open.emplace_back(from, split);
        open.emplace_back(split, to);
    }
    std::vector<Corner> result;
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (is_kept[i]) result.push_back(loop[i]);
    return result;
}

}  // namespace

StockOutline outlineOf(const MeridianStock& stock, double tolerance_mm)
{
    StockOutline outline;
    for (const std::vector<Corner>& loop : Boundary(stock).loops()) {
        if (!outline.z_mm.empty()) {
            outline.z_mm.push_back(notANumber);
            outline.x_mm.push_back(notANumber);
        }
        for (const Corner& corner : simplified(loop, tolerance_mm)) {
            outline.z_mm.push_back(corner.z_mm);
            outline.x_mm.push_back(corner.x_mm);
        }
    }
    return outline;
}

}  // namespace lathelier::stock
