#include "engine/stability/stability_plots.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/report/cells.h"

namespace lathelier::stability {
namespace {

constexpr double shownDepth = 5;  ///< upper end of the chart, in multiples of the least limit
constexpr std::size_t named = 3;  ///< number of labelled pockets

report::Axis speedAxis(const Interval& speed_rpm)
{
    report::Axis axis{LT_TEXT("Engine", "Spindle speed"), unit::rpm};
    axis.range = speed_rpm;
    return axis;
}

report::Axis depthAxis(const LobeResult& result)
{
    report::Axis axis = result.isRelative()
                            ? report::Axis{LT_TEXT("Engine", "Depth of cut, in multiples of the least limit"), Text{}}
                            : report::Axis{LT_TEXT("Engine", "Depth of cut"), unit::mm};
    axis.range = Interval{0, shownDepth * result.minimum_depth_mm.value_or(1)};
    return axis;
}

/// The three highest local maxima of the limit.
std::vector<report::Mark> pockets(const LobeLimit& limit, double highest, const Language& language)
{
    std::vector<std::size_t> peaks;
    for (std::size_t i = 1; i + 1 < limit.depth_mm.size(); ++i)
        if (limit.depth_mm[i] > limit.depth_mm[i - 1] && limit.depth_mm[i] >= limit.depth_mm[i + 1]) peaks.push_back(i);
    std::stable_sort(peaks.begin(), peaks.end(),
                     [&](std::size_t a, std::size_t b) { return limit.depth_mm[a] > limit.depth_mm[b]; });
    if (peaks.size() > named) peaks.resize(named);
    std::vector<report::Mark> marks;
    marks.reserve(peaks.size());
    for (const std::size_t i : peaks)
        marks.push_back(
            {limit.speed_rpm[i], std::min(limit.depth_mm[i], highest), fixed(limit.speed_rpm[i], 0, language)});
    return marks;
}

void addLine(report::Plot& plot, double speed_rpm, const Text& pattern, const Language& language)
{
    plot.limits.push_back({report::Limit::Direction::Vertical, speed_rpm,
                           fill(text(pattern, language), {{"speed", fixed(speed_rpm, 0, language)}}, language)});
}

/// The speed by depth; that of the rule, which knows no depth, only where there is none.
void addSpeeds(report::Plot& plot, const LobesMarks& marks, const Language& language)
{
    if (marks.safe && marks.safe->recommendedRpm())
        addLine(plot, *marks.safe->recommendedRpm(), LT_TEXT("Engine", "recommended {speed}"), language);
    if (marks.rule && !marks.safe)
        addLine(plot, marks.rule->recommended_rpm, LT_TEXT("Engine", "by the rule {speed}"), language);
    const bool is_at_selected = marks.point && marks.rule && marks.point->speed_rpm == marks.rule->selected_rpm;
    if (marks.rule && !is_at_selected)
        plot.limits.push_back(
            {report::Limit::Direction::Vertical, marks.rule->selected_rpm, LT_TEXT("Engine", "selected")});
}

void addToolRange(report::Plot& plot, const SpeedParameters& p)
{
    if (p.range_m_min.empty() || !p.diameter_mm) return;
    const Interval& range = p.range_m_min.front();
    const Interval range_rpm{spindleSpeed(range.from, *p.diameter_mm), spindleSpeed(range.to, *p.diameter_mm)};
    plot.regions.push_back(report::stretch(LT_TEXT("Engine", "below the tool's range"), {-HUGE_VAL, range_rpm.from}));
    plot.regions.push_back(report::stretch(LT_TEXT("Engine", "above the tool's range"), {range_rpm.to, HUGE_VAL}));
}

}  // namespace

report::Plot lobesPlot(const LobeResult& result, const LobesMarks& marks, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Stability lobes");
    if (result.parameters.relation == SpeedRelation::Published) plot.remark = LT_TEXT("Engine", "as published");
    plot.x = speedAxis(result.speed_rpm);
    plot.y = depthAxis(result);
    shadeStability(plot, result.limit.speed_rpm, result.limit.depth_mm);
    for (const Lobe& lobe : result.lobes) {
        report::Curve curve{{}, lobe.speed_rpm, lobe.depth_mm};
        curve.colour = report::ColourRole::Neutral;
        curve.thin = true;
        curve.has_readout = false;
        plot.curves.push_back(std::move(curve));
    }
    if (result.band) {
        report::Curve band{LT_TEXT("Engine", "95 % band"), result.limit.speed_rpm, result.band->high_mm,
                           report::Curve::Style::Band, result.band->low_mm};
        band.colour = report::ColourRole::Unstable;
        plot.curves.push_back(std::move(band));
    }
    report::Curve curve{LT_TEXT("Engine", "limit"), result.limit.speed_rpm, result.limit.depth_mm};
    curve.colour = report::ColourRole::Limit;
    plot.curves.push_back(std::move(curve));
    if (plot.y.range) plot.marks = pockets(result.limit, 0.96 * plot.y.range->to, language);
    addSpeeds(plot, marks, language);
    if (marks.rule) addToolRange(plot, marks.rule->parameters);
    if (marks.point) {
        report::Handle handle{operatingPointKey, report::Handle::Kind::Point, marks.point->speed_rpm,
                              marks.point->depth_mm, LT_TEXT("Engine", "operating point")};
        handle.x_range = result.speed_rpm;
        handle.y_range = plot.y.range;
        plot.handles.push_back(std::move(handle));
    }
    return plot;
}

void shadeStability(report::Plot& plot, const std::vector<double>& speed_rpm, std::vector<double> limit)
{
    for (double& depth : limit)
        if (std::isnan(depth)) depth = HUGE_VAL;
    const std::vector<double> zero(limit.size(), 0.0), top(limit.size(), HUGE_VAL);
    plot.regions.push_back(between(LT_TEXT("Engine", "stable"), report::ColourRole::Stable, speed_rpm, zero, limit));
    plot.regions.push_back(between(LT_TEXT("Engine", "chatter"), report::ColourRole::Unstable, speed_rpm, limit, top));
}

report::Plot chatterFrequencyPlot(const LobeResult& result)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Chatter frequency at the limit");
    plot.x = speedAxis(result.speed_rpm);
    plot.y = {LT_TEXT("Engine", "Chatter frequency"), unit::hz};
    plot.curves = {{{}, result.limit.speed_rpm, result.limit.frequency_hz}};
    // Neighbouring speeds of different lobes are not joined.
    for (std::size_t i = 1; i < result.limit.k.size(); ++i)
        if (result.limit.k[i] != result.limit.k[i - 1]) plot.curves.front().y[i] = NAN;
    return plot;
}

}  // namespace lathelier::stability
