#include "engine/form/roundness/roundness_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/form/roundness/prepared_profile.h"
#include "engine/form/roundness/roundness_report.h"

namespace lathelier::form {
namespace {

constexpr double um_per_mm = 1000;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int leastOrders = 50;  ///< shown of a spectrum

/// Numbers of the series' colours.
constexpr int profileColour = 0, leastSquaresColour = 2, zoneColour = 1, inscribedColour = 4, circumscribedColour = 3;

double degrees(double angle_rad)
{
    return angle_rad * 180 / std::numbers::pi;
}

/// What the deviations of the plot count from: the chosen circle; of a minimum zone the circle in its middle.
const FittedCircle& baseOf(const RoundnessResult& result)
{
    return result.circles.of(result.parameters.circle);
}

/// "profile, from MICI": a deviation says nothing without what it counts from.
std::string profileName(const RoundnessResult& result, const Language& language)
{
    const ReferenceCircle circle = result.parameters.circle;
    const Text words = circle == ReferenceCircle::MZCI ? LT_TEXT("Engine", "profile, from {circle} (mean)")
                                                       : LT_TEXT("Engine", "profile, from {circle}");
    return fill(text(words, language), {{"circle", std::string(name(circle))}}, language);
}

/// The evaluated points as deviations from the chosen circle, broken at gaps and closed.
report::PolarPlot::Trace profileTrace(const RoundnessResult& result, const Language& language)
{
    report::PolarPlot::Trace trace;
    trace.name = profileName(result, language);
    trace.colour = profileColour;
    const FittedCircle& base = baseOf(result);
    std::vector<double> angle, deviation;
    for (const Eigen::Vector2d& point : result.evaluated_mm) {
        const Eigen::Vector2d ray = point - base.centre_mm;
        angle.push_back(std::atan2(ray.y(), ray.x()));
        deviation.push_back(um_per_mm * (ray.norm() - base.radius_mm));
    }
    if (angle.empty()) return trace;
    const signal::AngularSampling sampling = signal::sampleAngles(angle);
    const double widest = signal::AngularSampling::gapFactor * sampling.median_spacing_rad;
    for (std::size_t i = 0; i <= angle.size(); ++i) {
        const bool again = i == angle.size();  // the first point closes the profile
        const std::size_t at = sampling.order[again ? 0 : i];
        const double here = degrees(sampling.angle_rad[again ? 0 : i]) + (again ? 360 : 0);
        if (i > 0 && here - degrees(sampling.angle_rad[i - 1]) > degrees(widest)) {
            trace.angle_deg.push_back(here);
            trace.deviation_um.push_back(nan);
        }
        trace.angle_deg.push_back(here);
        trace.deviation_um.push_back(deviation[at]);
    }
    return trace;
}

report::PolarPlot::ReferenceLine lineOf(const RoundnessResult& result, const FittedCircle& circle, double radius_mm,
                                        const std::string& name, int colour, bool dashed)
{
    const FittedCircle& base = baseOf(result);
    const Eigen::Vector2d off = um_per_mm * (circle.centre_mm - base.centre_mm);
    return {name, off.x(), off.y(), um_per_mm * (radius_mm - base.radius_mm), colour, dashed};
}

Text reasonOf(const RoundnessResult& result, int upr)
{
    for (const RoundnessHint& hint : result.hints)
        if (hint.upr == upr) return hint.meaning;
    return {};
}

}  // namespace

report::PolarPlot roundnessPolarPlot(const RoundnessResult& result, const Language& language)
{
    report::PolarPlot plot;
    plot.title = LT_TEXT("Engine", "Profile and reference circles");
    const FittedCircle& base = baseOf(result);
    plot.base_radius_mm = base.radius_mm;
    plot.traces = {profileTrace(result, language)};
    // The same whichever circle is chosen: only its uncertainty is known, and the four are there to be compared.
    const int decimals = result.circles.MZCI.RONt_um < 1 ? 3 : 2;
    const auto label = [&](ReferenceCircle circle) {
        return std::string(name(circle)) + "  RONt " + fixed(result.circles.of(circle).RONt_um, decimals, language) +
               " µm";
    };
    const ReferenceCircles& c = result.circles;
    plot.circles = {
        lineOf(result, c.LSCI, c.LSCI.radius_mm, label(ReferenceCircle::LSCI), leastSquaresColour, false),
        lineOf(result, c.MZCI, c.MZCI.outer_radius_mm, label(ReferenceCircle::MZCI), zoneColour, false),
        lineOf(result, c.MZCI, c.MZCI.inner_radius_mm, "", zoneColour, false),
        lineOf(result, c.MICI, c.MICI.inner_radius_mm, label(ReferenceCircle::MICI), inscribedColour, true),
        lineOf(result, c.MCCI, c.MCCI.outer_radius_mm, label(ReferenceCircle::MCCI), circumscribedColour, true)};
    for (const CircleContact& contact : base.contacts) {
        const auto at = std::find(result.evaluated_index.begin(), result.evaluated_index.end(), contact.index);
        if (at == result.evaluated_index.end()) continue;
        const auto i = static_cast<std::size_t>(at - result.evaluated_index.begin());
        const Eigen::Vector2d ray = result.evaluated_mm[i] - base.centre_mm;
        plot.contacts.push_back({degrees(std::atan2(ray.y(), ray.x())), um_per_mm * (ray.norm() - base.radius_mm),
                                 contact.side == CircleContact::Side::Outer});
    }
    return plot;
}

report::Plot spectrumPlot(const RoundnessResult& result, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Harmonics of the unfiltered profile");
    plot.x = {LT_TEXT("Engine", "Undulations per revolution"), LT_TEXT("Engine", "UPR")};
    plot.y = {LT_TEXT("Engine", "Amplitude"), LT_TEXT("Engine", "µm")};
    report::Curve bars;
    bars.style = report::Curve::Style::Bars;
    double largest = 0;
    for (const signal::Harmonic& h : result.harmonics) {
        if (h.upr < 2) continue;  // 1 is the place, not the form
        bars.x.push_back(h.upr - 0.5);
        bars.y.push_back(h.amplitude);
        bars.words.push_back(reasonOf(result, h.upr));
        largest = std::max(largest, h.amplitude);
    }
    if (bars.y.empty()) return plot;
    const double last = bars.x.back() + 0.5;
    bars.x.push_back(last + 0.5);
    double shown = leastOrders;
    for (std::size_t i = 0; i < bars.y.size(); ++i)
        if (bars.y[i] > 0.05 * largest) shown = std::max(shown, bars.x[i] + 5);
    const signal::TransmissionBand band = bandOf(result.parameters);
    for (const std::optional<double>& mark : {band.low_upr, band.high_upr})
        if (mark && *mark <= last) {
            plot.limits.push_back({report::Limit::Direction::Vertical, *mark,
                                   fill(text(LT_TEXT("Engine", "cut-off {upr} UPR"), language),
                                        {{"upr", fixed(*mark, 0, language)}}, language)});
            shown = std::max(shown, 1.2 * *mark);
        }
    plot.curves = {std::move(bars)};
    plot.x.range = Interval{1.5, std::min(shown, last) + 0.5};
    return plot;
}

report::Table methodTable(const RoundnessResult& result, const Language& language)
{
    report::Table table{LT_TEXT("Engine", "RONt by method: how much of the value is the method?"),
                        {LT_TEXT("Engine", "filter"), LT_TEXT("Engine", "outliers"), LT_TEXT("Engine", "LSCI (µm)"),
                         LT_TEXT("Engine", "MZCI (µm)"), LT_TEXT("Engine", "MICI (µm)"), LT_TEXT("Engine", "MCCI (µm)"),
                         LT_TEXT("Engine", "remark")},
                        {},
                        {0, 0, 3, 3, 3, 3, 0}};
    const signal::TransmissionBand asked = bandOf(result.parameters);
    for (const MethodRow& row : result.methods) {
        const bool chosen = row.band == asked && row.outliers == result.parameters.outliers;
        const Value remark = row.undersampled ? Value(LT_TEXT("Engine", "undersampled"))
                             : chosen         ? Value(LT_TEXT("Engine", "this result"))
                                              : Value(std::string());
        table.rows.push_back(
            {filterName(row.band, language),
             row.outliers == OutlierRule::Hampel ? LT_TEXT("Engine", "left out") : LT_TEXT("Engine", "kept"),
             row.RONt_um[0], row.RONt_um[1], row.RONt_um[2], row.RONt_um[3], remark});
    }
    return table;
}

report::Table harmonicsTable(const RoundnessResult& result)
{
    constexpr std::size_t most = 10;
    report::Table table{LT_TEXT("Engine", "Strongest harmonics"),
                        {LT_TEXT("Engine", "UPR"), LT_TEXT("Engine", "amplitude (µm)"), LT_TEXT("Engine", "phase (°)"),
                         LT_TEXT("Engine", "share of the form (%)"), LT_TEXT("Engine", "what it usually is")},
                        {},
                        {0, 3, 1, 1, 0}};
    std::vector<signal::Harmonic> strongest;
    double variance = 0;
    for (const signal::Harmonic& h : result.harmonics)
        if (h.upr >= 2) {
            strongest.push_back(h);
            variance += h.amplitude * h.amplitude;
        }
    std::stable_sort(strongest.begin(), strongest.end(),
                     [](const signal::Harmonic& a, const signal::Harmonic& b) { return a.amplitude > b.amplitude; });
    strongest.resize(std::min(strongest.size(), most));
    for (const signal::Harmonic& h : strongest)
        table.rows.push_back({std::int64_t{h.upr}, h.amplitude, degrees(h.phase_rad),
                              variance > 0 ? 100 * h.amplitude * h.amplitude / variance : 0, reasonOf(result, h.upr)});
    return table;
}

}  // namespace lathelier::form
