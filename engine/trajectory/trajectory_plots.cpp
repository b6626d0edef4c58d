#include "engine/trajectory/trajectory_plots.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace lathelier::trajectory {
namespace {

constexpr int measuredColour = 0, fittedColour = 1, toolColour = 1, meanColour = 1, singleColour = 0;

const Text alongAxis = LT_TEXT("Engine", "Along the workpiece, from the free end (mm)");

/// Closes a curve over the turn.
std::vector<double> closed(std::vector<double> values, double addend = 0)
{
    if (!values.empty()) values.push_back(values.front() + addend);
    return values;
}

}  // namespace

Plot diameterAlongAxis(const LongitudinalSection& section)
{
    Plot plot;
    plot.title = LT_TEXT("Engine", "Longitudinal section");
    plot.x.title = alongAxis;
    plot.y.title = LT_TEXT("Engine", "Diameter, deviation from its mean (µm)");
    const auto count = static_cast<double>(section.radius_mm.size());
    const double mean_mm = std::accumulate(section.radius_mm.begin(), section.radius_mm.end(), 0.0) / count;
    const auto [from, to] = std::minmax_element(section.z_mm.begin(), section.z_mm.end());

    std::vector<std::size_t> order(section.z_mm.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return section.z_mm[a] < section.z_mm[b]; });
    Curve measured{LT_TEXT("Engine", "sections"), {}, {}, Curve::Style::Line, {}, measuredColour};
    for (const std::size_t i : order) {
        measured.x.push_back(section.z_mm[i]);
        measured.y.push_back(2e3 * (section.radius_mm[i] - mean_mm));
    }
    Curve fitted{LT_TEXT("Engine", "taper and barrel"), {}, {}, Curve::Style::Line, {}, fittedColour};
    constexpr int steps = 60;
    for (int i = 0; i <= steps; ++i) {
        const double u = 2.0 * i / steps - 1;
        fitted.x.push_back(*from + (*to - *from) * i / steps);
        fitted.y.push_back(2e3 * (section.fit_mm[0] - mean_mm + u * (section.fit_mm[1] + u * section.fit_mm[2])));
    }
    plot.curves = {measured, fitted};
    return plot;
}

Plot roundnessAlongAxis(const TrajectoryResult& result)
{
    Plot plot;
    plot.title = LT_TEXT("Engine", "Roundness of the sections");
    const bool places = result.longitudinal.has_value();
    plot.x.title = places ? alongAxis : LT_TEXT("Engine", "Section");
    plot.y.title = "RONt (µm)";
    plot.y.range = Interval{0, 0};
    for (const form::ReferenceCircle circle : {form::ReferenceCircle::MZCI, form::ReferenceCircle::LSCI}) {
        Curve curve;
        curve.name = std::string(name(circle));
        for (const TrajectorySection& section : result.sections) {
            curve.x.push_back(places ? section.z_mm : section.section);
            curve.y.push_back(section.roundness.circles.of(circle).RONt_um);
            plot.y.range->to = std::max(plot.y.range->to, 1.15 * curve.y.back());
        }
        plot.curves.push_back(std::move(curve));
    }
    if (const auto& tolerance = result.parameters.form.tolerance_um) {
        plot.limits = {{Limit::Direction::Horizontal, *tolerance, LT_TEXT("Engine", "tolerance")}};
        plot.y.range->to = std::max(plot.y.range->to, 1.15 * *tolerance);
    }
    return plot;
}

Plot trajectoryPlot(const TrajectorySection& section)
{
    Plot plot;
    plot.title = LT_TEXT("Engine", "Trajectories over one turn");
    plot.x.title = "X (µm)";
    plot.y.title = "Y (µm)";
    const auto curve = [&](Text title, Probe x, Probe y, int colour) {
        return Curve{title,
                     closed(section.probes[static_cast<std::size_t>(x)].mean_um),
                     closed(section.probes[static_cast<std::size_t>(y)].mean_um),
                     Curve::Style::Line,
                     {},
                     colour};
    };
    plot.curves = {curve(LT_TEXT("Engine", "axis of the workpiece (X3, Y3)"), Probe::X3, Probe::Y3, measuredColour),
                   curve(LT_TEXT("Engine", "tool (Xp, Yp)"), Probe::Xp, Probe::Yp, toolColour)};
    plot.equal_scales = true;
    return plot;
}

Plot envelopePlot(const TrajectorySection& section)
{
    Plot plot;
    plot.title = LT_TEXT("Engine", "Radius about the spindle axis");
    plot.x.title = LT_TEXT("Engine", "Angle (°)");
    plot.y.title = LT_TEXT("Engine", "Deviation from the mean radius (µm)");
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
                               deviations(section.envelope_max_mm), Curve::Style::Band,
                               deviations(section.envelope_min_mm), singleColour});
    plot.curves.push_back(
        {LT_TEXT("Engine", "mean"), angle_deg, deviations(section.radius_mm), Curve::Style::Line, {}, meanColour});
    return plot;
}

PolarPlot errorMotionPlot(const TrajectorySection& section, double workpiece_diameter_mm)
{
    PolarPlot plot;
    plot.title = LT_TEXT("Engine", "Error motion of the spindle, sensitive direction X");
    plot.base_radius_mm = workpiece_diameter_mm / 2;
    const std::vector<double>& synchronous = section.spindle.synchronous_curve_um;
    const std::vector<double>& mean = section.probes[static_cast<std::size_t>(Probe::X3)].mean_um;
    const std::vector<double> angle_deg = closed(section.angle_deg, 360);
    const auto& revolutions = section.revolutions_um[static_cast<std::size_t>(Probe::X3)];
    for (std::size_t k = 0; k < revolutions.size(); ++k) {
        PolarPlot::Trace trace;
        if (k == 0) trace.name = LT_TEXT("Engine", "single revolutions");
        trace.angle_deg = angle_deg;
        for (std::size_t i = 0; i < revolutions[k].size(); ++i)
            trace.deviation_um.push_back(static_cast<double>(revolutions[k][i]) - mean[i] + synchronous[i]);
        if (k + 1 < revolutions.size() && !mean.empty())  // runs on into the next one
            trace.deviation_um.push_back(static_cast<double>(revolutions[k + 1].front()) - mean[0] + synchronous[0]);
        trace.angle_deg.resize(trace.deviation_um.size());
        trace.colour = singleColour;
        trace.thin = true;
        plot.traces.push_back(std::move(trace));
    }
    PolarPlot::Trace trace;
    trace.name = LT_TEXT("Engine", "synchronous (their mean)");
    trace.angle_deg = angle_deg;
    trace.deviation_um = closed(synchronous);
    trace.colour = meanColour;
    plot.traces.push_back(std::move(trace));
    return plot;
}

}  // namespace lathelier::trajectory
