#include "engine/stock/meridian_stock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/beam/segment_contour.h"
#include "engine/stock/stock_codes.h"

namespace lathelier::stock {
namespace {

constexpr std::size_t blockColumns = 64;
constexpr double thinnest_mm = 1e-9;  ///< thinner spans are rounding errors and removed

/// Lower and upper edge of a convex polygon over z, evaluated at ascending z.
class PolygonEdges {
public:
    explicit PolygonEdges(const ConvexPolygon& polygon) : polygon_(polygon)
    {
        for (std::size_t i = 1; i < polygon.size(); ++i) {
            const Corner& one = polygon[i];
            const Corner &low = polygon[lower_], &high = polygon[upper_];
            if (one.z_mm < low.z_mm || (one.z_mm == low.z_mm && one.x_mm < low.x_mm)) lower_ = i;
            if (one.z_mm < high.z_mm || (one.z_mm == high.z_mm && one.x_mm > high.x_mm)) upper_ = i;
            if (one.x_mm < polygon[bottom_].x_mm) bottom_ = i;
        }
    }

    double lowerAt(double z_mm)
    {
        while (z_mm > low_.until_mm) enter(low_, lower_, next(lower_));
        return low_.at(z_mm);
    }

    double upperAt(double z_mm)
    {
        while (z_mm > high_.until_mm) enter(high_, upper_, previous(upper_));
        return high_.at(z_mm);
    }

    /// Minimum of the lower edge from the current z to `to_mm`.
    double lowestUntil(double from_mm, double to_mm)
    {
        const Corner& bottom = polygon_[bottom_];
        if (bottom.z_mm >= from_mm && bottom.z_mm <= to_mm) return bottom.x_mm;
        const double here = lowerAt(from_mm);
        PolygonEdges ahead = *this;
        return std::min(here, ahead.lowerAt(to_mm));
    }

private:
    std::size_t next(std::size_t i) const { return i + 1 < polygon_.size() ? i + 1 : 0; }
    std::size_t previous(std::size_t i) const { return i > 0 ? i - 1 : polygon_.size() - 1; }

    /// An edge as a function of z; initially it ends at -∞.
    struct Edge {
        double z_mm = 0, x_mm = 0, slope = 0;
        double until_mm = -std::numeric_limits<double>::infinity();
        double at(double at_mm) const { return x_mm + (at_mm - z_mm) * slope; }
    };

    /// Sets the edge from corner `from` to `to` and advances `from`. The last edge is unbounded.
    void enter(Edge& edge, std::size_t& from, std::size_t to) const
    {
        const Corner &a = polygon_[from], &b = polygon_[to];
        const double along = b.z_mm - a.z_mm;
        edge = {a.z_mm, a.x_mm, along > 0 ? (b.x_mm - a.x_mm) / along : 0,
                along >= 0 ? b.z_mm : std::numeric_limits<double>::infinity()};
        from = to;
    }

    const ConvexPolygon& polygon_;
    std::size_t lower_ = 0, upper_ = 0, bottom_ = 0;
    Edge low_, high_;
};

/// Range of columns whose middles lie within an interval of z.
struct ColumnRange {
    std::size_t first = 0, end = 0;
};

ColumnRange columnsWithin(const Box& box, double step_mm, std::size_t count)
{
    const double most = static_cast<double>(count);
    const double first = std::clamp(std::ceil(box.low.z_mm / step_mm - 0.5), 0.0, most);
    const double end = std::clamp(std::floor(box.high.z_mm / step_mm - 0.5) + 1, 0.0, most);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(end)};
}

/// Calls visit(column, low, high) for all columns within the polygon, skipping blocks entirely below it, and
/// leave(block) after each visited block.
template <class Visit, class Leave>
void walk(const ConvexPolygon& polygon, double step_mm, std::size_t count, const std::vector<double>& block_tops,
          Visit visit, Leave leave)
{
    if (polygon.size() < 3 || count == 0) return;
    const Box box = boxOf(polygon);
    if (!(box.high.z_mm > box.low.z_mm)) return;
    const ColumnRange range = columnsWithin(box, step_mm, count);
    if (range.first >= range.end) return;
    PolygonEdges edges(polygon);
    const auto middle = [step_mm](std::size_t i) { return (static_cast<double>(i) + 0.5) * step_mm; };
    for (std::size_t block = range.first / blockColumns; block * blockColumns < range.end; ++block) {
        if (block_tops[block] <= box.low.x_mm) continue;
        const std::size_t first = std::max(range.first, block * blockColumns);
        const std::size_t end = std::min(range.end, (block + 1) * blockColumns);
        if (edges.lowestUntil(middle(first), middle(end - 1)) >= block_tops[block]) continue;
        for (std::size_t i = first; i < end; ++i) {
            const double z_mm = middle(i);
            visit(i, edges.lowerAt(z_mm), edges.upperAt(z_mm));
        }
        leave(block);
    }
}

void checkSegment(const ShaftSegment& segment, std::size_t number)
{
    const double least_mm = std::min(segment.start_diameter_mm, segment.end_diameter_mm);
    const double chord_mm = std::hypot(segment.length_mm, (segment.end_diameter_mm - segment.start_diameter_mm) / 2);
    const bool sound = segment.length_mm >= 0 && least_mm >= 0 && segment.bore_diameter_mm >= 0 &&
                       std::isfinite(segment.start_diameter_mm) && std::isfinite(segment.end_diameter_mm) &&
                       std::isfinite(segment.bore_diameter_mm) &&
                       (!segment.arc_radius_mm || 2 * std::abs(*segment.arc_radius_mm) >= chord_mm * (1 - 1e-9));
    if (!sound) throw Error(errors::stockSegmentImpossible, {{"segment", static_cast<std::int64_t>(number)}});
}

}  // namespace

MeridianStock::MeridianStock(const Shaft& shaft, double step_mm)
{
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) checkSegment(shaft.segments[i], i + 1);
    const double whole_mm = shaft.length_mm();
    if (!(whole_mm > 0) || !std::isfinite(whole_mm)) throw Error(errors::stockWithoutLength, {});
    const double wanted = std::ceil(whole_mm / std::max(step_mm, 1e-6) - 1e-9);
    const auto count = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(mostColumns)));
    step_mm_ = whole_mm / static_cast<double>(count);
    columns_.resize(count);
    std::size_t column = 0;
    double start_mm = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        const beam::SegmentContour contour(segment);
        const double end_mm = start_mm + segment.length_mm;
        const bool last = &segment == &shaft.segments.back();
        for (; column < count && (last || middle_mm(column) < end_mm); ++column) {
            const double at_mm = std::clamp(middle_mm(column) - start_mm, 0.0, segment.length_mm);
            const RadialSpan span{segment.bore_diameter_mm / 2, contour.radiusAt_mm(at_mm)};
            if (span.high_mm > span.low_mm) columns_[column].outer = span;
        }
        start_mm = end_mm;
    }
    blockTops_.assign((count + blockColumns - 1) / blockColumns, 0);
    for (std::size_t i = 0; i < count; ++i) {
        double& top = blockTops_[i / blockColumns];
        top = std::max(top, columns_[i].outer.high_mm);
    }
}

MeridianStock MeridianStock::turnedRound(double length_mm) const
{
    const double count = std::clamp(std::round(length_mm / step_mm_), 0.0, static_cast<double>(columns_.size()));
    MeridianStock turned;
    turned.step_mm_ = step_mm_;
    turned.columns_.assign(columns_.begin(), columns_.begin() + static_cast<std::ptrdiff_t>(count));
    std::reverse(turned.columns_.begin(), turned.columns_.end());
    turned.blockTops_.assign((turned.columns_.size() + blockColumns - 1) / blockColumns, 0);
    for (std::size_t i = 0; i < turned.columns_.size(); ++i) {
        double& top = turned.blockTops_[i / blockColumns];
        top = std::max(top, turned.columns_[i].outer.high_mm);
    }
    return turned;
}

std::vector<RadialSpan> MeridianStock::spans(std::size_t column) const
{
    std::vector<RadialSpan> result;
    appendSpans(column, result);
    return result;
}

void MeridianStock::appendSpans(std::size_t column, std::vector<RadialSpan>& spans) const
{
    const Column& one = columns_[column];
    spans.insert(spans.end(), one.inner.begin(), one.inner.end());
    if (one.outer.high_mm > one.outer.low_mm) spans.push_back(one.outer);
}

std::optional<double> MeridianStock::outerRadius_mm(double z_mm) const
{
    if (!(z_mm >= 0 && z_mm <= length_mm()) || columns_.empty()) return {};
    const RadialSpan& outer = columns_[std::min(static_cast<std::size_t>(z_mm / step_mm_), columns_.size() - 1)].outer;
    return outer.high_mm > outer.low_mm ? std::optional(outer.high_mm) : std::nullopt;
}

std::optional<double> MeridianStock::innerRadius_mm(double z_mm) const
{
    if (!outerRadius_mm(z_mm)) return {};
    return spans(std::min(static_cast<std::size_t>(z_mm / step_mm_), columns_.size() - 1)).front().low_mm;
}

double MeridianStock::largestRadius_mm() const
{
    return blockTops_.empty() ? 0 : *std::max_element(blockTops_.begin(), blockTops_.end());
}

double MeridianStock::area_mm2() const
{
    double sum_mm = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i)
        for (const RadialSpan& span : spans(i)) sum_mm += span.high_mm - span.low_mm;
    return sum_mm * step_mm_;
}

double MeridianStock::volume_mm3() const
{
    double sum_mm2 = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i)
        for (const RadialSpan& span : spans(i)) sum_mm2 += span.high_mm * span.high_mm - span.low_mm * span.low_mm;
    return std::numbers::pi * sum_mm2 * step_mm_;
}

Removal MeridianStock::remove(const ConvexPolygon& polygon)
{
    Removal removal;
    walk(
        polygon, step_mm_, columns_.size(), blockTops_,
        [&](std::size_t i, double low_mm, double high_mm) {
            if (low_mm < columns_[i].outer.high_mm) removeFrom(columns_[i], low_mm, high_mm, removal);
        },
        [&](std::size_t block) {
            const std::size_t end = std::min((block + 1) * blockColumns, columns_.size());
            double top = 0;
            for (std::size_t i = block * blockColumns; i < end; ++i) top = std::max(top, columns_[i].outer.high_mm);
            blockTops_[block] = top;
        });
    removal.area_mm2 *= step_mm_;
    removal.volume_mm3 *= std::numbers::pi * step_mm_;
    return removal;
}

/// Adds a length to the area and a difference of squares to the volume; the caller scales both.
void MeridianStock::removeFrom(Column& column, double low_mm, double high_mm, Removal& removal)
{
    const auto taken = [&removal](double from_mm, double to_mm) {
        removal.area_mm2 += to_mm - from_mm;
        removal.volume_mm3 += to_mm * to_mm - from_mm * from_mm;
    };
    RadialSpan& outer = column.outer;
    const bool is_simple = low_mm - outer.low_mm > thinnest_mm && outer.high_mm - high_mm <= thinnest_mm;
    if (is_simple) {  // common case: a cut from above that leaves material below
        taken(low_mm, outer.high_mm);
        outer.high_mm = low_mm;
        return;
    }
    std::vector<RadialSpan> before = std::move(column.inner);
    if (outer.high_mm > outer.low_mm) before.push_back(outer);
    column.inner.clear();
    for (const RadialSpan& span : before) {
        const double from_mm = std::max(low_mm, span.low_mm), to_mm = std::min(high_mm, span.high_mm);
        if (!(to_mm > from_mm)) {
            column.inner.push_back(span);
            continue;
        }
        const bool below = from_mm - span.low_mm > thinnest_mm, above = span.high_mm - to_mm > thinnest_mm;
        if (below) column.inner.push_back({span.low_mm, from_mm});
        if (above) column.inner.push_back({to_mm, span.high_mm});
        taken(below ? from_mm : span.low_mm, above ? to_mm : span.high_mm);
    }
    outer = {};
    if (column.inner.empty()) return;
    outer = column.inner.back();
    column.inner.pop_back();
}

StockOverlap MeridianStock::overlap(const ConvexPolygon& polygon, double least_mm) const
{
    StockOverlap found;
    double first_mm = 0, last_mm = 0;
    walk(
        polygon, step_mm_, columns_.size(), blockTops_,
        [&](std::size_t i, double low_mm, double high_mm) {
            if (low_mm >= columns_[i].outer.high_mm) return;
            StockOverlap here;
            measureOverlap(columns_[i], {low_mm, high_mm}, middle_mm(i), least_mm, here);
            if (!here.isThere()) return;
            if (!found.isThere()) first_mm = here.z_mm;
            last_mm = here.z_mm;
            if (here.depth_mm > found.depth_mm + thinnest_mm) found = here;
        },
        [](std::size_t) {});
    if (found.isThere()) found.width_mm = last_mm - first_mm + step_mm_;
    return found;
}

void MeridianStock::measureOverlap(const Column& column, const RadialSpan& within, double z_mm, double least_mm,
                                   StockOverlap& found)
{
    const auto measure = [&](const RadialSpan& span) {
        const double low_mm = std::max(span.low_mm, within.low_mm);
        const double depth_mm = std::min(span.high_mm, within.high_mm) - low_mm;
        if (depth_mm > least_mm && depth_mm > thinnest_mm && depth_mm > found.depth_mm)
            found = {depth_mm, z_mm, low_mm, 0};
    };
    for (const RadialSpan& span : column.inner) measure(span);
    measure(column.outer);
}

}  // namespace lathelier::stock
