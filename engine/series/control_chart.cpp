#include "engine/series/control_chart.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/series/series_codes.h"

namespace lathelier::series {
namespace {

constexpr double limitsPerMovingRange = 2.66;  // 3 / 1.128
constexpr std::int64_t longestAllowed = 6;     // seven in succession are a sign
constexpr std::int64_t leastForCapability = 50;
constexpr double partsOfDrift = 100;

using Points = std::vector<archive::SeriesPoint>;

void addSpread(ControlChart& chart, const Points& points)
{
    double sum = 0;
    chart.smallest = chart.largest = points.front().value;
    for (const archive::SeriesPoint& point : points) {
        sum += point.value;
        chart.smallest = std::min(chart.smallest, point.value);
        chart.largest = std::max(chart.largest, point.value);
    }
    const auto count = static_cast<double>(points.size());
    chart.mean = sum / count;
    if (points.size() < 2) return;
    double squares = 0, ranges = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        squares += (points[i].value - chart.mean) * (points[i].value - chart.mean);
        if (i > 0) ranges += std::abs(points[i].value - points[i - 1].value);
    }
    chart.standard_deviation = std::sqrt(squares / (count - 1));
    const double reach = limitsPerMovingRange * ranges / (count - 1);
    chart.lower_control_limit = chart.mean - reach;
    chart.upper_control_limit = chart.mean + reach;
    for (const archive::SeriesPoint& point : points)
        chart.out_of_control += point.value < *chart.lower_control_limit || point.value > *chart.upper_control_limit;
}

int signOf(double value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

void addRuns(ControlChart& chart, const Points& points)
{
    std::int64_t run = 0, trend = 0;
    int side = 0, direction = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int at = signOf(points[i].value - chart.mean);
        run = at != 0 && at == side ? run + 1 : at != 0 ? 1 : 0;
        side = at;
        const int to = i > 0 ? signOf(points[i].value - points[i - 1].value) : 0;
        // The first step joins two values.
        trend = to != 0 && to == direction ? trend + 1 : to != 0 ? 2 : 1;
        direction = to;
        chart.longest_run = std::max(chart.longest_run, run);
        chart.longest_trend = std::max(chart.longest_trend, trend);
    }
}

/// Least squares over the number of the part.
void addDrift(ControlChart& chart, const Points& points)
{
    const auto count = static_cast<double>(points.size());
    if (points.size() < 3) return;
    const double middle = (count - 1) / 2, moment = count * (count * count - 1) / 12;
    double product = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        product += (static_cast<double>(i) - middle) * (points[i].value - chart.mean);
    const double slope = product / moment;
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double rest = points[i].value - chart.mean - slope * (static_cast<double>(i) - middle);
        squares += rest * rest;
    }
    const auto freedom = static_cast<std::int64_t>(points.size()) - 2;
    const double error = std::sqrt(squares / static_cast<double>(freedom) / moment);
    chart.drift_per_100_parts = partsOfDrift * slope;
    chart.drift_expanded_uncertainty_per_100_parts = partsOfDrift * studentQuantile(0.975, freedom) * error;
}

void addVerdicts(ControlChart& chart, const Points& points)
{
    for (const archive::SeriesPoint& point : points) {
        if (!point.verdict) continue;
        ++chart.judged;
        chart.out_of_tolerance += *point.verdict == Verdict::Fail;
        chart.undecided += *point.verdict == Verdict::Undecided;
    }
}

void addCapability(ControlChart& chart, const Points& points, Notes& notes)
{
    const archive::SeriesPoint& first = points.front();
    const bool alike = std::all_of(points.begin(), points.end(), [&first](const archive::SeriesPoint& point) {
        return point.lower_limit == first.lower_limit && point.upper_limit == first.upper_limit;
    });
    if (!alike) {
        notes.push_back({notes::limitsDiffer, {}});
        return;
    }
    chart.lower_limit = first.lower_limit;
    chart.upper_limit = first.upper_limit;
    if (!chart.lower_limit && !chart.upper_limit) return;
    if (!chart.standard_deviation || !(*chart.standard_deviation > 0)) return;
    const double spread = 3 * *chart.standard_deviation;
    if (chart.lower_limit && chart.upper_limit)
        chart.capability_pp = (*chart.upper_limit - *chart.lower_limit) / (2 * spread);
    if (chart.upper_limit) chart.capability_ppk = (*chart.upper_limit - chart.mean) / spread;
    if (chart.lower_limit) {
        const double below = (chart.mean - *chart.lower_limit) / spread;
        chart.capability_ppk = chart.capability_ppk ? std::min(*chart.capability_ppk, below) : below;
    }
    if (chart.count < leastForCapability)
        notes.push_back({notes::capabilityFewValues, {{"count", chart.count}, {"least", leastForCapability}}});
    if (!chart.isInControl()) notes.push_back({notes::capabilityOutOfControl, {}});
}

}  // namespace

bool ControlChart::isInControl() const
{
    return out_of_control == 0 && longest_run <= longestAllowed && longest_trend <= longestAllowed;
}

ControlChart controlChart(const std::vector<archive::SeriesPoint>& points, Notes& notes)
{
    ControlChart chart;
    chart.count = static_cast<std::int64_t>(points.size());
    addSpread(chart, points);
    addRuns(chart, points);
    addDrift(chart, points);
    addVerdicts(chart, points);
    addCapability(chart, points, notes);
    return chart;
}

const std::vector<QuantityOf<ControlChart>>& quantitiesOf(const ControlChart*)
{
    using C = ControlChart;
    static const auto all = describedBy<C>(
        quantity<C>("count", &C::count, {LT_TEXT("Engine", "Values")}),
        quantity<C>("judged", &C::judged, {LT_TEXT("Engine", "… with a limit")}),
        quantity<C>("out_of_tolerance", &C::out_of_tolerance, {LT_TEXT("Engine", "… out of tolerance")}),
        quantity<C>("undecided", &C::undecided, {LT_TEXT("Engine", "… that cannot be decided")}),
        quantity<C>("mean", &C::mean, {LT_TEXT("Engine", "Mean"), {}, 4}),
        quantity<C>("standard_deviation", &C::standard_deviation, {LT_TEXT("Engine", "Standard deviation"), {}, 4}),
        quantity<C>("smallest", &C::smallest, {LT_TEXT("Engine", "Smallest"), {}, 4}),
        quantity<C>("largest", &C::largest, {LT_TEXT("Engine", "Largest"), {}, 4}),
        quantity<C>("lower_limit", &C::lower_limit, {LT_TEXT("Engine", "Lower limit"), {}, 4}),
        quantity<C>("upper_limit", &C::upper_limit, {LT_TEXT("Engine", "Upper limit"), {}, 4}),
        quantity<C>("Pp", &C::capability_pp, {LT_TEXT("Engine", "Pp (limits over 6 s)"), {}, 2}),
        quantity<C>("Ppk", &C::capability_ppk, {LT_TEXT("Engine", "Ppk (nearer limit over 3 s)"), {}, 2}),
        quantity<C>("lower_control_limit", &C::lower_control_limit, {LT_TEXT("Engine", "Lower control limit"), {}, 4}),
        quantity<C>("upper_control_limit", &C::upper_control_limit, {LT_TEXT("Engine", "Upper control limit"), {}, 4}),
        quantity<C>("out_of_control", &C::out_of_control, {LT_TEXT("Engine", "Values outside the control limits")}),
        quantity<C>("longest_run", &C::longest_run,
                    {LT_TEXT("Engine", "Most values in succession on one side of the mean")}),
        quantity<C>("longest_trend", &C::longest_trend,
                    {LT_TEXT("Engine", "Most values in succession that rise or fall")}),
        quantity<C>("in_control", &C::isInControl, {LT_TEXT("Engine", "In statistical control")}),
        quantity<C>("drift_per_100_parts", &C::drift_per_100_parts, {LT_TEXT("Engine", "Drift over 100 parts"), {}, 4}),
        quantity<C>("drift_expanded_uncertainty_per_100_parts", &C::drift_expanded_uncertainty_per_100_parts,
                    {LT_TEXT("Engine", "… its uncertainty (95 %)"), {}, 4}));
    return all;
}

}  // namespace lathelier::series
