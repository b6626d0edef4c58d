#include "engine/form/roundness/roundness_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/form/roundness/prepared_profile.h"
#include "engine/form/roundness/roundness_hints.h"
#include "engine/form/roundness/roundness_report.h"

namespace lathelier::form {
namespace {

constexpr int leastOrders = 50;  ///< shown of a spectrum
/// Harmonics refer to the least-squares circle, which is the first circle of the plot.
constexpr std::array leastSquaresFirst{ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI,
                                       ReferenceCircle::MCCI};

/// Numbers of the series' colours.
constexpr int profileColour = 0, leastSquaresColour = 2, zoneColour = 1, inscribedColour = 4, circumscribedColour = 3;

double degrees(double angle_rad)
{
    return angle_rad * 180 / std::numbers::pi;
}

/// Reference of the plotted deviations: the chosen circle; for a minimum zone its mean circle.
const FittedCircle& baseOf(const RoundnessResult& result)
{
    return result.circles.of(result.parameters.circle);
}

/// "profile, from MICI": a deviation needs its reference.
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
            trace.deviation_um.push_back(notANumber);
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

int colourOf(ReferenceCircle circle)
{
    switch (circle) {
        case ReferenceCircle::LSCI: return leastSquaresColour;
        case ReferenceCircle::MZCI: return zoneColour;
        case ReferenceCircle::MICI: return inscribedColour;
        case ReferenceCircle::MCCI: return circumscribedColour;
    }
    return zoneColour;
}

/// Two circles as far apart as the tolerance allows, about the middle of the zone; omitted where they would compress
/// the profile.
void addToleranceRing(const RoundnessResult& result, report::PolarPlot& plot, const Language& language)
{
    constexpr double mostZones = 3;  // a wider ring is not drawn
    const FittedCircle& base = baseOf(result);
    const std::optional<double>& tolerance_um = result.parameters.tolerance_um;
    if (!tolerance_um || *tolerance_um > mostZones * base.RONt_um) return;
    const double middle_um = um_per_mm * ((base.inner_radius_mm + base.outer_radius_mm) / 2 - base.radius_mm);
    const std::string words = fill(text(LT_TEXT("Engine", "tolerance {tolerance_um} µm"), language),
                                   {{"tolerance_um", *tolerance_um}}, language);
    for (const int side : {1, -1}) {
        plot.circles.push_back({side > 0 ? words : std::string(), 0, 0, middle_um + side * *tolerance_um / 2,
                                report::ColourRole::Limit, true});
    }
}

/// Labels of the strongest harmonics.
void nameStrongest(report::Plot& plot, const report::Curve& bars, const Language& language)
{
    constexpr std::size_t most = 3;
    std::vector<std::size_t> order(bars.y.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return bars.y[a] > bars.y[b]; });
    for (std::size_t k = 0; k < std::min(most, order.size()); ++k) {
        const std::size_t i = order[k];
        if (!(bars.y[i] > 0.1 * bars.y[order[0]])) break;
        const double upr = bars.x[i] + 0.5;
        const Text word = shortCause(static_cast<int>(std::lround(upr)));
        std::string words = fixed(upr, 0, language);
        words += ' ';
        words += text(word, language);
        plot.marks.push_back({upr, bars.y[i], std::move(words)});
    }
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
    plot.title = LT_TEXT("Engine", "Profile and reference circle");
    const ReferenceCircle chosen = result.parameters.circle;
    const FittedCircle& base = baseOf(result);
    plot.base_radius_mm = base.radius_mm;
    plot.traces = {profileTrace(result, language)};
    // Independent of the chosen circle: only its uncertainty is known, and the four are compared here.
    const int decimals = result.circles.MZCI.RONt_um < 1 ? 3 : 2;
    const auto label = [&](ReferenceCircle circle) {
        return std::string(name(circle)) + "  RONt " +
               shownNumber(result.circles.of(circle).RONt_um, micrometre, decimals, language) + " " +
               text(shownUnit(micrometre, language).unit, language);
    };
    for (const ReferenceCircle which : leastSquaresFirst) {
        const FittedCircle& circle = result.circles.of(which);
        const bool is_pair = which == ReferenceCircle::MZCI;
        const bool is_outer = is_pair || which == ReferenceCircle::MCCI;
        const double fitted_mm = which == ReferenceCircle::LSCI ? circle.radius_mm
                                 : is_outer                     ? circle.outer_radius_mm
                                                                : circle.inner_radius_mm;
        const int colour = colourOf(which);
        const auto add = [&](double radius_mm, const std::string& words, bool dashed) {
            plot.circles.push_back(lineOf(result, circle, radius_mm, words, colour, dashed));
            if (which != chosen) plot.circles.back().asked = name(which);
        };
        add(fitted_mm, label(which), false);
        if (is_pair) add(circle.inner_radius_mm, "", false);
        if (which == chosen && !is_pair && !is_outer) add(circle.outer_radius_mm, "", true);
        if (which == chosen && !is_pair && fitted_mm != circle.inner_radius_mm) add(circle.inner_radius_mm, "", true);
    }
    plot.rings = {{LT_TEXT("Engine", "zone"), 0, 0, um_per_mm * (base.inner_radius_mm - base.radius_mm),
                   um_per_mm * (base.outer_radius_mm - base.radius_mm), colourOf(chosen)}};
    addToleranceRing(result, plot, language);
    for (const CircleContact& contact : base.contacts) {
        const auto at = std::find(result.evaluated_index.begin(), result.evaluated_index.end(), contact.index);
        if (at == result.evaluated_index.end()) continue;
        const auto i = static_cast<std::size_t>(at - result.evaluated_index.begin());
        const Eigen::Vector2d ray = result.evaluated_mm[i] - base.centre_mm;
        report::PolarPlot::Mark mark;
        mark.angle_deg = degrees(std::atan2(ray.y(), ray.x()));
        mark.deviation_um = um_per_mm * (ray.norm() - base.radius_mm);
        mark.outer = contact.side == CircleContact::Side::Outer;
        const double turned = mark.angle_deg < 0 ? mark.angle_deg + 360 : mark.angle_deg;
        std::string words = fixed(turned, 0, language);
        words += "°  ";
        words += mark.deviation_um < 0 ? "−" : "+";
        words += shownNumber(std::abs(mark.deviation_um), micrometre, decimals, language);
        mark.name = std::move(words);
        plot.contacts.push_back(std::move(mark));
    }
    return plot;
}

report::Plot spectrumPlot(const RoundnessResult& result, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Harmonics of the unfiltered profile");
    plot.x = {LT_TEXT("Engine", "Undulations per revolution"), LT_TEXT("Engine", "UPR")};
    plot.y = {LT_TEXT("Engine", "Amplitude"), micrometre};
    report::Curve bars;
    bars.style = report::Curve::Style::Bars;
    double largest = 0;
    for (const signal::Harmonic& h : result.harmonics) {
        if (h.upr < 2) continue;  // order 1 is eccentricity, not form
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
    nameStrongest(plot, bars, language);
    constexpr double roomForNames = 1.15;
    if (largest > 0) plot.y.range = Interval{0, roomForNames * largest};
    plot.curves = {std::move(bars)};
    plot.x.range = Interval{1.5, std::min(shown, last) + 0.5};
    return plot;
}

report::Table methodTable(const RoundnessResult& result, const Language& language)
{
    report::Table table{LT_TEXT("Engine", "RONt by method: how much of the value is the method?"),
                        {LT_TEXT("Engine", "filter"), LT_TEXT("Engine", "outliers"),
                         report::Labelled{LT_TEXT("Engine", "LSCI"), micrometre},
                         report::Labelled{LT_TEXT("Engine", "MZCI"), micrometre},
                         report::Labelled{LT_TEXT("Engine", "MICI"), micrometre},
                         report::Labelled{LT_TEXT("Engine", "MCCI"), micrometre}, LT_TEXT("Engine", "remark")},
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
                        {LT_TEXT("Engine", "UPR"), report::Labelled{LT_TEXT("Engine", "amplitude"), micrometre},
                         LT_TEXT("Engine", "phase (°)"), LT_TEXT("Engine", "share of the form (%)"),
                         LT_TEXT("Engine", "what it usually is")},
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
