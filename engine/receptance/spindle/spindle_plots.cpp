#include "engine/receptance/spindle/spindle_plots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/receptance/eirc/spindle_line.h"
#include "engine/receptance/frf_plots.h"
#include "engine/receptance/receptance_quantities.h"

namespace lathelier::receptance {
namespace {

/// Scaled receptances of equal unit, so that one axis shows all three.
struct ScaledTable {
    std::vector<double> frequency_hz;
    std::vector<Complex> entries[3];
};

ScaledTable scaledTable(const SpindleReceptance& spindle)
{
    ScaledTable scaled;
    if (const auto* table = std::get_if<SpindleTable>(&spindle.source))
        scaled.frequency_hz = table->frequency_hz;
    else
        scaled.frequency_hz = {10, 5000};
    for (const double frequency : scaled.frequency_hz) {
        const ScaledSpindle line = scaledOf(spindle.at(frequency));
        for (int i = 0; i < 3; ++i) scaled.entries[i].push_back(line[i]);
    }
    return scaled;
}

template <class Show>
report::Plot entriesPlot(const SpindleReceptance& spindle, Text title, report::Axis axis, Show show)
{
    report::Plot plot;
    plot.title = title;
    plot.x = frequencyAxis();
    plot.y = std::move(axis);
    constexpr Text names[] = {LT_TEXT("Engine", "H: deflection per force"),
                              LT_TEXT("Engine", "L × 100 mm: deflection per moment"),
                              LT_TEXT("Engine", "P × (100 mm)²: rotation per moment")};
    const ScaledTable scaled = scaledTable(spindle);
    for (std::size_t i = 0; i < 3; ++i) {
        report::Curve curve{names[i], scaled.frequency_hz, {}};
        curve.y.reserve(scaled.frequency_hz.size());
        bool any = false;
        for (const Complex& value : scaled.entries[i]) {
            any = any || value != Complex(0);
            curve.y.push_back(value == Complex(0) ? NAN : show(value));
        }
        if (any) plot.curves.push_back(std::move(curve));  // springs have no cross receptance
    }
    return plot;
}

report::Curve magnitudeCurve(report::Caption name, const Frf& frf)
{
    report::Curve curve{std::move(name), frf.frequency_hz, {}};
    curve.y.reserve(frf.value.size());
    for (const Complex& value : frf.value) curve.y.push_back(std::abs(value));
    return curve;
}

/// |predicted - measured| / |measured| by line, in percent.
report::Curve residualCurve(report::Caption name, const CheckedResponse& response)
{
    report::Curve curve{std::move(name), response.measured.frequency_hz, {}};
    curve.y.reserve(response.measured.value.size());
    for (std::size_t i = 0; i < response.measured.value.size(); ++i)
        curve.y.push_back(
            100 * std::abs((response.predicted.value[i] - response.measured.value[i]) / response.measured.value[i]));
    return curve;
}

/// By what the responses are ordered: where their noise is known, by it; those held out are not compared.
double misfitOf(const CheckedResponse& response)
{
    return response.used ? response.chi2_per_dof.value_or(response.rms_percent) : -1;
}

}  // namespace

report::Plot spindleMagnitudePlot(const SpindleReceptance& spindle)
{
    return entriesPlot(spindle, LT_TEXT("Engine", "Receptance of the chuck face"),
                       {LT_TEXT("Engine", "Magnitude"), LT_TEXT("Engine", "mm/N"), report::Axis::Scale::Logarithmic},
                       [](const Complex& value) { return std::abs(value); });
}

report::Plot spindlePhasePlot(const SpindleReceptance& spindle)
{
    return entriesPlot(spindle, LT_TEXT("Engine", "Phase of the chuck face"), {LT_TEXT("Engine", "Phase"), unit::deg},
                       [](const Complex& value) { return deg_per_rad * std::arg(value); });
}

report::Plot conditionPlot(const SpindleIdentification& found)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Condition of each line");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Condition"), {}, report::Axis::Scale::Logarithmic};
    plot.curves = {{{}, found.frequency_hz, found.condition}};
    return plot;
}

report::Plot residualPlot(const SpindleCheck& check, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Residual of each response");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Residual"), unit::percent, report::Axis::Scale::Logarithmic};
    const auto worst =
        std::max_element(check.responses.begin(), check.responses.end(),
                         [](const CheckedResponse& a, const CheckedResponse& b) { return misfitOf(a) < misfitOf(b); });
    for (auto one = check.responses.begin(); one != check.responses.end(); ++one) {
        if (one == worst) continue;
        plot.curves.push_back(residualCurve({}, *one));
        plot.curves.back().thin = true;
        plot.curves.back().colour = report::ColourRole::Neutral;
    }
    plot.curves.push_back({LT_TEXT("Engine", "all that are used"), check.frequency_hz, check.residual_percent});
    plot.curves.back().colour = 0;
    if (worst == check.responses.end()) return plot;
    const Values nodes{
        {"rod", static_cast<std::int64_t>(worst->rod + 1)}, {"respond", worst->respond}, {"excite", worst->excite}};
    plot.curves.push_back(residualCurve(
        fill(text(LT_TEXT("Engine", "worst: rod {rod}, {respond}/{excite}"), language), nodes, language), *worst));
    plot.curves.back().colour = 1;
    return plot;
}

report::Plot heldOutPlot(const SpindleCheck& check, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Rod held out: measured and predicted");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Magnitude"), LT_TEXT("Engine", "mm/N"), report::Axis::Scale::Logarithmic};
    std::vector<report::Curve> predicted;
    for (const CheckedResponse& response : check.responses) {
        if (response.used) continue;
        report::Curve measured =
            magnitudeCurve(plot.curves.empty() ? LT_TEXT("Engine", "measured") : Text{}, response.measured);
        measured.style = report::Curve::Style::Points;
        measured.colour = report::ColourRole::Neutral;
        plot.curves.push_back(std::move(measured));
        const Values nodes{{"respond", response.respond}, {"excite", response.excite}};
        predicted.push_back(
            magnitudeCurve(fill(text(LT_TEXT("Engine", "{respond}/{excite}, predicted"), language), nodes, language),
                           response.predicted));
        predicted.back().colour = static_cast<int>(predicted.size()) - 1;
    }
    for (report::Curve& curve : predicted) plot.curves.push_back(std::move(curve));  // drawn last, on top
    return plot;
}

report::Table responsesTable(const SpindleCheck& check)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Residual of each response");
    for (const QuantityOf<CheckedResponse>& column : quantities<CheckedResponse>()) {
        table.columns.emplace_back(report::Labelled{column.info.label, column.info.unit});
        table.decimals.push_back(column.info.decimals);
    }
    for (const CheckedResponse& response : check.responses) {
        std::vector<Value>& row = table.rows.emplace_back();
        for (const QuantityOf<CheckedResponse>& column : quantities<CheckedResponse>())
            row.push_back(column.get(response));
    }
    return table;
}

}  // namespace lathelier::receptance
