#include "engine/trajectory/trajectory_plots.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "engine/core/units.h"
#include "engine/trajectory/channel_map.h"

namespace lathelier::trajectory {
namespace {

/// Numbers of the series' colours.
constexpr int workpieceColour = 0, toolColour = 1, meanColour = 1, singleColour = 4;

constexpr std::size_t mostMarks = 60;  ///< largest number of revolution marks drawn

const report::Axis zAxis{LT_TEXT("Engine", "Along the workpiece, from the free end"), unit::mm};

std::string sectionName(const TrajectorySection& section, const Language& language)
{
    return fill(text(LT_TEXT("Engine", "section {section}"), language), {{"section", std::int64_t{section.section}}},
                language);
}

/// Closes a curve over the turn.
std::vector<double> closed(std::vector<double> values, double addend = 0)
{
    if (!values.empty()) values.push_back(values.front() + addend);
    return values;
}

}  // namespace

std::vector<double> partAngles_deg(const TrajectorySection& section)
{
    std::vector<double> angles = section.body_angle_deg.empty() ? section.angle_deg : section.body_angle_deg;
    for (double& angle : angles) {
        angle = std::fmod(angle, 360);
        if (angle < 0) angle += 360;
    }
    return angles;
}

report::Plot longitudinalPlot(const LongitudinalSection& section, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Longitudinal section");
    plot.x = zAxis;
    plot.y = {LT_TEXT("Engine", "Radius, deviation from its mean"), unit::um};
    const auto count = static_cast<double>(section.radius_mm.size());
    const double mean_mm = std::accumulate(section.radius_mm.begin(), section.radius_mm.end(), 0.0) / count;
    const auto [from, to] = std::minmax_element(section.z_mm.begin(), section.z_mm.end());

    std::vector<std::size_t> order(section.z_mm.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return section.z_mm[a] < section.z_mm[b]; });
    const auto named = [&](Text pattern, double value_um) {
        return fill(text(pattern, language), {{"value_um", value_um}}, language);
    };
    report::Curve parabola{named(section.barrel_um >= 0 ? LT_TEXT("Engine", "barrel {value_um:1} µm on radius")
                                                        : LT_TEXT("Engine", "saddle {value_um:1} µm on radius"),
                                 std::abs(section.barrel_um))};
    report::Curve line{named(LT_TEXT("Engine", "taper {value_um:1} µm on diameter"), section.taper_diameter_um)};
    line.style = report::Curve::Style::Dashed;
    line.has_readout = false;
    report::Curve measured{LT_TEXT("Engine", "sections")};
    measured.style = report::Curve::Style::Points;
    for (const std::size_t i : order) {
        measured.x.push_back(section.z_mm[i]);
        measured.y.push_back(1e3 * (section.radius_mm[i] - mean_mm));
    }
    constexpr int steps = 100;
    const auto& [c0, c1, c2] = section.fit_mm;
    for (int i = 0; i <= steps && *to > *from; ++i) {
        const double u = 2.0 * i / steps - 1;
        parabola.x.push_back(*from + (*to - *from) * i / steps);
        parabola.y.push_back(1e3 * (c0 + u * (c1 + u * c2) - mean_mm));
        // Line of the taper at the mean height of the parabola.
        line.y.push_back(1e3 * (c0 + c1 * u + c2 / 3 - mean_mm));
    }
    line.x = parabola.x;
    plot.curves = {std::move(parabola), std::move(line), std::move(measured)};
    return plot;
}

report::Plot roundnessAlongAxis(const TrajectoryResult& result)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Roundness of the sections");
    const bool places = result.longitudinal.has_value();
    plot.x = places ? zAxis : report::Axis{LT_TEXT("Engine", "Section")};
    plot.y = {"RONt", unit::um};
    plot.y.range = Interval{0, 0};
    for (const form::ReferenceCircle circle : {form::ReferenceCircle::MZCI, form::ReferenceCircle::LSCI}) {
        report::Curve curve;
        curve.name = std::string(name(circle));
        for (const TrajectorySection& section : result.sections) {
            curve.x.push_back(places ? section.z_mm : section.section);
            curve.y.push_back(section.roundness.circles.of(circle).RONt_um);
            plot.y.range->to = std::max(plot.y.range->to, 1.15 * curve.y.back());
        }
        plot.curves.push_back(std::move(curve));
    }
    if (const auto& tolerance = result.parameters.form.tolerance_um) {
        plot.limits.push_back({report::Limit::Direction::Horizontal, *tolerance, LT_TEXT("Engine", "tolerance")});
        plot.y.range->to = std::max(plot.y.range->to, 1.15 * *tolerance);
    }
    return plot;
}

report::Plot trajectoryPlot(const TrajectorySection& section, const Language& language,
                            const std::vector<TrajectorySection>& others)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Trajectories over one turn");
    plot.remark = sectionName(section, language);
    plot.x = {"X", unit::um};
    plot.y = {"Y", unit::um};
    plot.along = {LT_TEXT("Engine", "angle"), unit::deg};
    plot.equal_scales = true;
    const auto add = [&](const report::Caption& name, const TrajectorySection& of, Probe x, Probe y, int colour) {
        report::Curve curve{name, closed(of.mean_um(x)), closed(of.mean_um(y)), report::Curve::Style::Line, {}, colour};
        curve.along = closed(partAngles_deg(of));
        curve.thin = &of != &section;
        plot.curves.push_back(std::move(curve));
    };
    for (const TrajectorySection& other : others) {
        if (other.section == section.section) continue;
        add({}, other, Probe::X3, Probe::Y3, workpieceColour);
        add({}, other, Probe::Xp, Probe::Yp, toolColour);
    }
    add(LT_TEXT("Engine", "axis of the workpiece (X3, Y3)"), section, Probe::X3, Probe::Y3, workpieceColour);
    add(LT_TEXT("Engine", "tool (Xp, Yp)"), section, Probe::Xp, Probe::Yp, toolColour);
    return plot;
}

report::Plot coordinatesPlot(const TrajectorySection& section, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Coordinates over the angle");
    plot.remark = sectionName(section, language);
    plot.x = {LT_TEXT("Engine", "Angle as recorded"), unit::deg};
    plot.y = {LT_TEXT("Engine", "Displacement"), unit::um};
    for (std::size_t probe = 0; probe < section.probes.size(); ++probe)
        plot.curves.push_back({name(static_cast<Probe>(probe)), section.angle_deg, section.probes[probe].mean_um});
    const double sum_mm = std::accumulate(section.radius_mm.begin(), section.radius_mm.end(), 0.0);
    report::Curve radius{LT_TEXT("Engine", "R − mean"), section.angle_deg};
    for (const double radius_mm : section.radius_mm)
        radius.y.push_back(1e3 * (radius_mm - sum_mm / static_cast<double>(section.radius_mm.size())));
    plot.curves.push_back(std::move(radius));
    return plot;
}

report::Plot envelopePlot(const TrajectorySection& section)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Radius about the spindle axis");
    plot.x = {LT_TEXT("Engine", "Angle"), unit::deg};
    plot.y = {LT_TEXT("Engine", "Deviation from the mean radius"), unit::um};
    const double mean_mm = section.roundness.circles.LSCI.radius_mm;
    const auto deviations = [&](const std::vector<double>& radius_mm) {
        std::vector<double> values;
        values.reserve(radius_mm.size());
        for (const double radius : radius_mm) values.push_back(1e3 * (radius - mean_mm));
        return closed(values);
    };
    const std::vector<double> angle_deg = closed(section.angle_deg, 360);
    if (!section.envelope_min_mm.empty())
        plot.curves.push_back({LT_TEXT("Engine", "single revolutions: from the smallest to the largest"), angle_deg,
                               deviations(section.envelope_max_mm), report::Curve::Style::Band,
                               deviations(section.envelope_min_mm), singleColour});
    plot.curves.push_back({LT_TEXT("Engine", "mean"),
                           angle_deg,
                           deviations(section.radius_mm),
                           report::Curve::Style::Line,
                           {},
                           meanColour});
    return plot;
}

report::Plot signalsPlot(const std::vector<TimeSignal>& recorded, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Signals");
    plot.x = {LT_TEXT("Engine", "Time"), unit::s};
    const auto displaces = [](const TimeSignal& signal) {
        return !signal.signal.empty() && signal.signal != "marker" && signal.signal != "angle";
    };
    // Without a usable map all channels are shown as recorded, so that they can be identified.
    const bool mapped = std::any_of(recorded.begin(), recorded.end(), displaces);
    plot.y =
        mapped ? report::Axis{LT_TEXT("Engine", "Displacement"), unit::um} : report::Axis{LT_TEXT("Engine", "Value")};
    const std::vector<double>* starts = nullptr;
    for (const TimeSignal& signal : recorded) {
        if (!starts && !signal.revolution_starts_s.empty()) starts = &signal.revolution_starts_s;
        if (!mapped || displaces(signal))
            plot.curves.push_back({mapped ? signal.signal : signal.channel, signal.time_s, signal.value});
    }
    if (!starts) return plot;
    plot.remark = fill(text(LT_TEXT("Engine", "{count} revolution marks"), language),
                       {{"count", static_cast<std::int64_t>(starts->size())}}, language);
    plot.limits.resize(std::min(starts->size(), mostMarks));
    for (std::size_t i = 0; i < plot.limits.size(); ++i) {
        plot.limits[i].direction = report::Limit::Direction::Vertical;
        plot.limits[i].place = (*starts)[i];
    }
    plot.limits.front().name = LT_TEXT("Engine", "marks");
    // Initial range of a few revolutions, so that single revolutions are visible; zoom out for the rest.
    if (starts->size() > 6) plot.x.range = Interval{(*starts)[0], (*starts)[5]};
    return plot;
}

report::PolarPlot errorMotionPlot(const TrajectorySection& section, double workpiece_diameter_mm, Probe probe,
                                  const Language& language)
{
    const auto p = static_cast<std::size_t>(probe);
    report::PolarPlot plot;
    plot.title = LT_TEXT("Engine", "Error motion of all revolutions");
    plot.base_radius_mm = workpiece_diameter_mm / 2;
    const std::vector<double>& synchronous = section.error_motion[p].synchronous_curve_um;
    const std::vector<double>& average = section.probes[p].mean_um;
    const std::vector<double> angle_deg = closed(partAngles_deg(section));
    const auto& revolutions = section.revolutions_um[p];
    for (std::size_t k = 0; k < revolutions.size(); ++k) {
        report::PolarPlot::Trace trace;
        if (k == 0) trace.name = LT_TEXT("Engine", "single revolutions");
        trace.angle_deg = angle_deg;
        for (std::size_t i = 0; i < revolutions[k].size(); ++i)
            trace.deviation_um.push_back(static_cast<double>(revolutions[k][i]) - average[i] + synchronous[i]);
        if (k + 1 < revolutions.size() && !average.empty())  // connects to the next revolution
            trace.deviation_um.push_back(static_cast<double>(revolutions[k + 1].front()) - average[0] + synchronous[0]);
        trace.angle_deg.resize(trace.deviation_um.size());
        trace.colour = singleColour;
        trace.thin = true;
        plot.traces.push_back(std::move(trace));
    }
    report::PolarPlot::Trace trace;
    trace.name = fill(text(LT_TEXT("Engine", "synchronous motion of {probe}"), language),
                      {{"probe", std::string(name(probe))}}, language);
    trace.angle_deg = angle_deg;
    trace.deviation_um = closed(synchronous);
    trace.colour = meanColour;
    plot.traces.push_back(std::move(trace));
    return plot;
}

}  // namespace lathelier::trajectory
