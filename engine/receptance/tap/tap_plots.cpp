#include "engine/receptance/tap/tap_plots.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"
#include "engine/receptance/tap/tap_spectra.h"

namespace lathelier::receptance {
namespace {

constexpr int signalColour = 0, windowColour = 1;
constexpr int windowPoints = 60;
constexpr double lowest_db = -80;

Text motionUnit(FrfQuantity quantity)
{
    if (quantity == FrfQuantity::Receptance) return unit::mm;
    return quantity == FrfQuantity::Mobility ? LT_TEXT("Engine", "mm/s") : LT_TEXT("Engine", "mm/s²");
}

Text motionName(FrfQuantity quantity)
{
    if (quantity == FrfQuantity::Receptance) return LT_TEXT("Engine", "Displacement");
    return quantity == FrfQuantity::Mobility ? LT_TEXT("Engine", "Velocity") : LT_TEXT("Engine", "Acceleration");
}

/// Blocks of the hits, named once for the legend.
void addBlocks(const TapStudy& study, report::Plot& plot)
{
    bool has_used = false, has_left = false;
    for (const TapHit& hit : study.result.hits) {
        const double trigger_s = static_cast<double>(hit.trigger - hit.first) / study.result.rate_hz;
        const double from_s = study.shiftedTime_s(hit) - trigger_s;
        const double to_s = from_s + static_cast<double>(study.result.samples) / study.result.rate_hz;
        bool& is_named = hit.used ? has_used : has_left;
        report::Caption name;
        if (!is_named) name = hit.used ? LT_TEXT("Engine", "hit used") : LT_TEXT("Engine", "hit left out");
        is_named = true;
        plot.regions.push_back(report::stretch(name, {from_s, to_s},
                                               hit.used ? report::ColourRole::Stable : report::ColourRole::Unstable));
    }
}

/// Window of a block, as high as its signal.
void addWindow(const TapStudy& study, const TapHit& hit, bool of_force, double height, report::Plot& plot)
{
    const TapResult& result = study.result;
    if (result.parameters.window == TapWindow::None || !hit.used) return;
    const double block_s = static_cast<double>(result.samples) / result.rate_hz;
    const double trigger_s = static_cast<double>(hit.trigger - hit.first) / result.rate_hz;
    const double width_s = static_cast<double>(hit.pulse_end - std::min(hit.pulse_end, hit.trigger)) / result.rate_hz;
    const TapWindows windows = windowsOf(result.parameters, block_s, width_s);
    const double end_s = of_force ? std::min(block_s, trigger_s + 2 * windows.force_window_s) : block_s;
    report::Curve curve;
    const bool is_first = std::none_of(plot.curves.begin(), plot.curves.end(), [](const report::Curve& one) {
        return one.style == report::Curve::Style::Dashed;
    });
    if (is_first) curve.name = LT_TEXT("Engine", "window");
    for (int k = 0; k <= windowPoints; ++k) {
        const double time_s = end_s * k / windowPoints;
        curve.x.push_back(study.shiftedTime_s(hit) - trigger_s + time_s);
        curve.y.push_back(height * std::exp(-windows.decay_1_s * time_s) *
                          (of_force ? forceWindow(windows, time_s, trigger_s) : 1));
    }
    curve.style = report::Curve::Style::Dashed;
    curve.colour = windowColour;
    curve.has_readout = false;
    plot.curves.push_back(std::move(curve));
}

report::Plot signalPlot(const TapStudy& study, const std::vector<TapTrace>& traces, Text title, report::Axis y)
{
    report::Plot plot;
    plot.title = title;
    if (traces.size() > 1) plot.remark = LT_TEXT("Engine", "records one behind another");
    plot.x = {LT_TEXT("Engine", "Time"), unit::s};
    plot.y = std::move(y);
    report::Curve curve;
    for (const TapTrace& trace : traces) {
        if (!curve.x.empty()) {  // breaks the line between records
            curve.x.push_back(trace.time_s.empty() ? curve.x.back() : trace.time_s.front());
            curve.y.push_back(notANumber);
        }
        curve.x.insert(curve.x.end(), trace.time_s.begin(), trace.time_s.end());
        curve.y.insert(curve.y.end(), trace.value.begin(), trace.value.end());
    }
    curve.colour = signalColour;
    plot.curves.push_back(std::move(curve));
    addBlocks(study, plot);
    return plot;
}

report::Limit atFrequency(double frequency_hz, Text pattern, const Language& language)
{
    return {report::Limit::Direction::Vertical, frequency_hz,
            fill(text(pattern, language), {{"frequency", fixed(frequency_hz, 1, language)}}, language)};
}

}  // namespace

report::Plot tapForcePlot(const TapStudy& study, const Language& language)
{
    report::Plot plot = signalPlot(study, study.force, LT_TEXT("Engine", "Force of the hammer"),
                                   {LT_TEXT("Engine", "Force"), unit::newton});
    std::int64_t number = 0;
    for (const TapHit& hit : study.result.hits) {
        ++number;
        addWindow(study, hit, true, hit.peak_N, plot);
        const Text pattern =
            hit.fault == HitFault::None ? LT_TEXT("Engine", "{number}") : LT_TEXT("Engine", "{number}: {reason}");
        plot.marks.push_back({study.shiftedTime_s(hit), hit.peak_N,
                              fill(text(pattern, language),
                                   {{"number", number}, {"reason", text(words(hit.fault), language)}}, language)});
    }
    return plot;
}

report::Plot tapMotionPlot(const TapStudy& study, const Language&)
{
    const FrfQuantity quantity = study.result.measured;
    report::Plot plot = signalPlot(study, study.motion, LT_TEXT("Engine", "Motion of the sensor"),
                                   {motionName(quantity), motionUnit(quantity)});
    for (std::size_t k = 0; k < study.result.hits.size(); ++k)
        addWindow(study, study.result.hits[k], false, study.largest[k], plot);
    return plot;
}

report::Plot tapSpectrumPlot(const TapResult& result, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Spectrum of the force");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Force, of its maximum"), LT_TEXT("Engine", "dB")};
    report::Curve curve{{}, result.frequency_hz, {}};
    for (const double force_db : result.force_db) curve.y.push_back(std::max(force_db, lowest_db));
    plot.curves.push_back(std::move(curve));
    plot.limits.push_back({report::Limit::Direction::Horizontal, -result.parameters.force_drop_db, {}});
    plot.limits.push_back(atFrequency(result.usable_to_hz, LT_TEXT("Engine", "usable up to {frequency} Hz"), language));
    return plot;
}

report::Plot tapPhasePlot(const TapResult& result)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Phase of the receptance");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Phase"), unit::deg};
    report::Curve curve{{}, result.response.frequency_hz, {}};
    for (const auto& value : result.response.value) curve.y.push_back(deg_per_rad * std::arg(value));
    plot.curves.push_back(std::move(curve));
    return plot;
}

report::Plot tapCoherencePlot(const TapResult& result, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Coherence");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Coherence γ²"), {}, report::Axis::Scale::Linear, Interval{0, 1.05}};
    if (result.coherence.empty()) return plot;
    plot.curves.push_back({{}, result.frequency_hz, result.coherence});
    plot.limits.push_back(atFrequency(result.usable_to_hz, LT_TEXT("Engine", "usable up to {frequency} Hz"), language));
    return plot;
}

}  // namespace lathelier::receptance
