#include "engine/report/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::report {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double xAir = 0.02, yAir = 0.06;  ///< margins beside the data, as shares of their extent
constexpr double namesAir = 3;              ///< factor of the upper margin where vertical lines are labelled

/// Range of the visible data on one axis.
class Extent {
public:
    explicit Extent(const Axis& axis) : logarithmic_(axis.scale == Axis::Scale::Logarithmic) {}

    void add(double value)
    {
        if (!isDrawable(value) || (logarithmic_ && value <= 0)) return;
        from_ = std::min(from_, value);
        to_ = std::max(to_, value);
    }
    void add(const std::vector<double>& values)
    {
        for (const double value : values) add(value);
    }

    /// With margins; `grounded` data start at zero.
    Interval interval(double below, double above, bool grounded = false) const
    {
        if (!(from_ <= to_)) return logarithmic_ ? Interval{1, 10} : Interval{0, 1};
        if (logarithmic_) {
            const double span = std::max(std::log(to_ / from_), 0.1);
            return {from_ * std::exp(-below * span), to_ * std::exp(above * span)};
        }
        // Smaller ranges are not resolved on the sheet or in double precision.
        const double least = std::max(1e-9 * std::max(std::abs(from_), std::abs(to_)), 1e-12);
        if (to_ - from_ < least) {
            const double half = from_ == 0 ? 0.5 : 0.05 * std::abs(from_);
            return {from_ - half, to_ + half};
        }
        return {grounded && from_ == 0 ? 0 : from_ - below * (to_ - from_), to_ + above * (to_ - from_)};
    }

private:
    bool logarithmic_;
    double from_ = infinity, to_ = -infinity;
};

/// The range stated for the axis, if it can be drawn.
std::optional<Interval> asked(const Axis& axis)
{
    if (!axis.range || !(axis.range->from < axis.range->to)) return std::nullopt;
    if (!isDrawable(axis.range->from) || !isDrawable(axis.range->to)) return std::nullopt;
    if (axis.scale == Axis::Scale::Logarithmic && axis.range->from <= 0) return std::nullopt;
    return axis.range;
}

double inside(double value, const std::optional<Interval>& range)
{
    return range ? std::max(range->from, std::min(value, range->to)) : value;
}

}  // namespace

bool isDrawable(double value)
{
    return std::abs(value) < 1e100;
}

std::string axisLabel(const Axis& axis, const Language& language)
{
    const std::string title = captionText(axis.title, language);
    return axis.unit.empty() ? title : title + " (" + text(shownUnit(axis.unit, language).unit, language) + ")";
}

std::vector<double> placesOf(const Curve& curve)
{
    if (curve.style != Curve::Style::Bars) return curve.x;
    std::vector<double> places;
    for (std::size_t i = 0; i + 1 < curve.x.size(); ++i) places.push_back((curve.x[i] + curve.x[i + 1]) / 2);
    return places;
}

Region stretch(Caption name, const Interval& x, ChartColour colour)
{
    return {std::move(name), colour, {x.from, x.to, x.to, x.from}, {-infinity, -infinity, infinity, infinity}};
}

Region between(Caption name, ChartColour colour, const std::vector<double>& x, const std::vector<double>& low,
               const std::vector<double>& high)
{
    Region region{std::move(name), colour, x, low};
    region.x.insert(region.x.end(), x.rbegin(), x.rend());
    region.y.insert(region.y.end(), high.rbegin(), high.rend());
    return region;
}

void moveHandle(Handle& handle, double x, double y)
{
    if (handle.kind != Handle::Kind::Horizontal && isDrawable(x)) handle.x = inside(x, handle.x_range);
    if (handle.kind != Handle::Kind::Vertical && isDrawable(y)) handle.y = inside(y, handle.y_range);
}

Interval shownX(const Plot& plot)
{
    if (const auto range = asked(plot.x)) return *range;
    Extent extent(plot.x);
    for (const Curve& curve : plot.curves) extent.add(curve.x);
    for (const Region& region : plot.regions) extent.add(region.x);
    for (const Limit& limit : plot.limits)
        if (limit.direction == Limit::Direction::Vertical) extent.add(limit.place);
    for (const Mark& mark : plot.marks) extent.add(mark.x);
    for (const Handle& handle : plot.handles)
        if (handle.kind != Handle::Kind::Horizontal) extent.add(handle.x);
    return extent.interval(xAir, xAir);
}

Interval shownY(const Plot& plot)
{
    if (const auto range = asked(plot.y)) return *range;
    Extent extent(plot.y);
    bool upright = false, bars = false;
    for (const Curve& curve : plot.curves) {
        extent.add(curve.y);
        if (curve.style == Curve::Style::Band) extent.add(curve.y_low);
        bars = bars || curve.style == Curve::Style::Bars;
    }
    if (bars) extent.add(0);
    for (const Region& region : plot.regions) extent.add(region.y);
    for (const Limit& limit : plot.limits) {
        const bool vertical = limit.direction == Limit::Direction::Vertical;
        if (!vertical) extent.add(limit.place);
        upright = upright || vertical;
    }
    for (const Mark& mark : plot.marks) extent.add(mark.y);
    for (const Handle& handle : plot.handles) {
        if (handle.kind != Handle::Kind::Vertical) extent.add(handle.y);
        upright = upright || handle.kind == Handle::Kind::Vertical;
    }
    return extent.interval(yAir, upright ? namesAir * yAir : yAir, bars);
}

DeviationColours coloursOf(const ColourMap& map)
{
    return {map.limit, map.tolerance, map.steps, map.marked};
}

double ColourMap::at(double x_place, double y_place) const
{
    const double u = (x_place - x_from) / (x_to - x_from) * columns;
    const double v = (y_place - y_from) / (y_to - y_from) * rows;
    if (empty() || !(u >= 0 && u < columns && v >= 0 && v < rows)) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(
        values[static_cast<std::size_t>(v) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(u)]);
}

}  // namespace lathelier::report
