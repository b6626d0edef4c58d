#include "engine/stability/simulation/cut_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/report/cells.h"
#include "engine/signal/fourier.h"
#include "engine/stability/simulation/simulation_report.h"

namespace lathelier::stability {
namespace {

constexpr int mostColumns = 720;  ///< columns of the unrolled surface
constexpr double umPerMm = 1000;
constexpr double leastAmplitude_um = 1e-4;  ///< smaller amplitudes are not displayed

/// Calls `take` with each revolution up to `last`: its number, the surface before and after the tool.
template <class Take>
void followSurface(const SimulationResult& result, int last, const Take& take)
{
    const auto steps = static_cast<std::size_t>(result.steps_per_revolution);
    std::vector<double> before(steps, 0.0), behind(steps, 0.0);
    for (int revolution = 0; revolution <= last; ++revolution) {
        const std::size_t begin = static_cast<std::size_t>(revolution) * steps;
        for (std::size_t i = 0; i < steps; ++i)
            behind[i] = result.chip_mm[begin + i] > 0 ? result.deflection_mm[begin + i]
                                                      : before[i] + result.parameters.feed_mm_rev;
        take(revolution, before, behind);
        std::swap(before, behind);
    }
}

}  // namespace

WavePhase phaseOf(double frequency_hz, double speed_rpm, double feed_mm_rev)
{
    WavePhase phase;
    const double turns = 60 * frequency_hz / speed_rpm;
    phase.whole = static_cast<int>(std::floor(turns));
    const double part = turns - phase.whole;
    phase.phase_deg = 360 * part;
    phase.fraction = part > 0.5 ? part - 1 : part;
    phase.period_mm =
        phase.fraction == 0 ? std::numeric_limits<double>::infinity() : feed_mm_rev / std::abs(phase.fraction);
    return phase;
}

int revolutionsOf(const SimulationResult& result)
{
    const auto steps = static_cast<std::size_t>(std::max(1, result.steps_per_revolution));
    return static_cast<int>(result.deflection_mm.size() / steps);
}

WavePair wavesOf(const SimulationResult& result, int revolution)
{
    const int last = std::clamp(revolution, 0, std::max(0, revolutionsOf(result) - 1));
    WavePair waves;
    waves.turns = result.waves.turns;
    waves.angle_deg = result.waves.angle_deg;
    followSurface(result, last, [&](int now, const std::vector<double>& before, const std::vector<double>&) {
        if (now != last) return;
        const auto begin =
            result.deflection_mm.begin() + static_cast<std::ptrdiff_t>(now) * result.steps_per_revolution;
        waves.outer_mm = before;
        waves.inner_mm.assign(begin, begin + result.steps_per_revolution);
    });
    return waves;
}

report::Plot wavesPlot(const SimulationResult& result, const WavePair& waves, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Outer and inner wave");
    const WavePhase phase = phaseOf(result.frequency_hz, *result.parameters.speed_rpm, result.parameters.feed_mm_rev);
    plot.remark =
        fill(text(LT_TEXT("Engine", "{whole} whole waves, ε = {phase}°"), language),
             {{"whole", std::int64_t{phase.whole}}, {"phase", fixed(phase.phase_deg, 0, language)}}, language);
    plot.x = {LT_TEXT("Engine", "Angle"), unit::deg};
    plot.x.range = Interval{0, 360};
    plot.y = {LT_TEXT("Engine", "Height above the bottom of the steady cut"), unit::mm};
    std::vector<double> outer = waves.outer_mm, inner = waves.inner_mm;
    for (double& height : outer) height += result.parameters.feed_mm_rev - result.static_deflection_mm;
    for (double& height : inner) height -= result.static_deflection_mm;
    report::Region chip =
        report::between(LT_TEXT("Engine", "chip"), report::ColourRole::Neutral, waves.angle_deg, inner, outer);
    for (std::size_t i = 0; i < inner.size(); ++i)  // no chip where the tool is out of the cut
        if (inner[i] > outer[i]) chip.y[i] = outer[i];
    plot.regions.push_back(std::move(chip));
    plot.curves = {{LT_TEXT("Engine", "outer wave, left before"), waves.angle_deg, std::move(outer)},
                   {LT_TEXT("Engine", "inner wave, path of the tool"), waves.angle_deg, std::move(inner)}};
    return plot;
}

report::ColourMap surfaceMap(const SimulationResult& result, int last, int revolutions)
{
    report::ColourMap map;
    map.title = LT_TEXT("Engine", "Turned surface, unrolled");
    map.x = {LT_TEXT("Engine", "Angle"), unit::deg};
    map.y = {LT_TEXT("Engine", "Along the axis"), unit::mm};
    map.value = {LT_TEXT("Engine", "Height"), unit::um};
    const int steps = result.steps_per_revolution;
    last = std::clamp(last, 0, std::max(0, revolutionsOf(result) - 1));
    const int first = std::max(0, last + 1 - revolutions);
    map.columns = std::min(steps, mostColumns);
    map.rows = last + 1 - first;
    map.x_from = 0;
    map.x_to = 360;
    map.y_from = first * result.parameters.feed_mm_rev;
    map.y_to = (last + 1) * result.parameters.feed_mm_rev;
    map.values.reserve(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows));
    double largest = 0;
    followSurface(result, last, [&](int now, const std::vector<double>&, const std::vector<double>& behind) {
        if (now < first) return;
        for (int column = 0; column < map.columns; ++column) {
            const auto begin = static_cast<std::size_t>(std::int64_t{column} * steps / map.columns);
            const auto end = static_cast<std::size_t>(std::int64_t{column + 1} * steps / map.columns);
            double sum = 0;
            for (std::size_t i = begin; i < end; ++i) sum += behind[i];
            const double height = umPerMm * (sum / static_cast<double>(end - begin) - result.static_deflection_mm);
            largest = std::max(largest, std::abs(height));
            map.values.push_back(static_cast<float>(height));
        }
    });
    map.limit = largest > 0 ? largest : 1;
    return map;
}

report::Plot amplitudePlot(const SimulationResult& result)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Amplitude from revolution to revolution");
    plot.x = {LT_TEXT("Engine", "Revolution"), Text{}, report::Axis::Scale::Whole};
    plot.y = {LT_TEXT("Engine", "Amplitude"), unit::um, report::Axis::Scale::Logarithmic};
    report::Curve found{LT_TEXT("Engine", "simulated")};
    found.style = report::Curve::Style::Points;
    for (int revolution = 0; revolution < revolutionsOf(result); ++revolution) {
        const auto begin =
            result.deflection_mm.begin() + static_cast<std::ptrdiff_t>(revolution) * result.steps_per_revolution;
        const auto [least, largest] = std::minmax_element(begin, begin + result.steps_per_revolution);
        const double amplitude = umPerMm * (*largest - *least) / 2;
        if (amplitude < leastAmplitude_um) break;
        found.x.push_back(revolution + 1);
        found.y.push_back(amplitude);
    }
    if (found.y.empty()) return plot;
    // From the third revolution on, as the first ones contain the transient of the entry.
    const std::size_t from = std::min<std::size_t>(2, found.y.size() - 1);
    report::Curve alone{LT_TEXT("Engine", "by the growth alone"), {}, {}, report::Curve::Style::Dashed};
    const double top = 3 * *std::max_element(found.y.begin(), found.y.end());
    for (std::size_t i = from; i < found.y.size(); ++i) {
        const double amplitude =
            found.y[from] * std::pow(result.growth_per_revolution, static_cast<double>(i) - static_cast<double>(from));
        if (amplitude > top || amplitude < leastAmplitude_um) break;
        alone.x.push_back(found.x[i]);
        alone.y.push_back(amplitude);
    }
    plot.curves = {std::move(found), std::move(alone)};
    return plot;
}

report::Plot spectrumPlot(const SimulationResult& result, double highest_hz, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Spectrum of the deflection");
    plot.x = {LT_TEXT("Engine", "Frequency"), unit::hz};
    plot.x.range = Interval{0, highest_hz};
    plot.y = {LT_TEXT("Engine", "Amplitude"), unit::um};
    const std::vector<double>& all = result.deflection_mm;
    std::vector<double> part(all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    if (part.size() < 8) return plot;
    const auto count = static_cast<double>(part.size());
    double mean = 0;
    for (const double x : part) mean += x / count;
    for (std::size_t i = 0; i < part.size(); ++i)
        part[i] = (part[i] - mean) * (1 - std::cos(2 * std::numbers::pi * static_cast<double>(i) / count));
    part.resize(signal::quickTransformLength(4 * part.size()),
                0.0);  // zero padding, so that peaks show their full height
    const double line_hz = 1 / (result.step_s * static_cast<double>(part.size()));
    const auto amplitudes = signal::FourierTransform(part.size()).forward(part);
    report::Curve curve;
    for (std::size_t k = 0; k < amplitudes.size() && static_cast<double>(k) * line_hz <= highest_hz; ++k) {
        curve.x.push_back(static_cast<double>(k) * line_hz);
        curve.y.push_back(umPerMm * 2 / count * std::abs(amplitudes[k]));
    }
    plot.curves = {std::move(curve)};
    plot.limits.push_back(
        {report::Limit::Direction::Vertical, result.frequency_hz, fixed(result.frequency_hz, 1, language) + " Hz"});
    return plot;
}

}  // namespace lathelier::stability
