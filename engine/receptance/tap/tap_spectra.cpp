#include "engine/receptance/tap/tap_spectra.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/signal/fourier.h"

namespace lathelier::receptance {
namespace {

constexpr double blocksPerDecay = 3;    ///< usual exponential window: 5 % at the end of the block
constexpr double pulsesInWindow = 2;    ///< usual force window, in widths of the pulse
constexpr std::size_t leastAtRest = 8;  ///< samples in front of a hit that tell the offset
constexpr double endShare = 0.1;        ///< of the block, for what is left of the response
constexpr double overRest = 3;          ///< what is left counts above so many times the noise

/// Offset and noise of the samples in front of a hit; the last quarter may hold the start of the pulse.
struct AtRest {
    double offset = 0;
    double noise = 0;
};

AtRest restOf(const std::vector<double>& values, const TapHit& hit, double otherwise)
{
    const std::size_t count = (hit.trigger - hit.first) * 3 / 4;
    if (count < leastAtRest) return {otherwise, 0};
    AtRest rest;
    for (std::size_t i = 0; i < count; ++i) rest.offset += values[hit.first + i];
    rest.offset /= static_cast<double>(count);
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i)
        squares += (values[hit.first + i] - rest.offset) * (values[hit.first + i] - rest.offset);
    rest.noise = std::sqrt(squares / static_cast<double>(count - 1));
    return rest;
}

double medianOf(const std::vector<double>& values)
{
    std::vector<double> sorted = values;
    return upperMedianInPlace(sorted);
}

/// The rms of the last part of a block, of its peak, in percent; `is_noise` where it is no more than that.
double leftOf(const std::vector<double>& block, double noise, bool& is_noise)
{
    const auto from = static_cast<std::size_t>((1 - endShare) * static_cast<double>(block.size()));
    double peak = 0, squares = 0;
    for (const double value : block) peak = std::max(peak, std::abs(value));
    for (std::size_t i = from; i < block.size(); ++i) squares += block[i] * block[i];
    const double rms = std::sqrt(squares / static_cast<double>(block.size() - from));
    is_noise = rms <= overRest * noise;
    return peak > 0 ? 100 * rms / peak : 0;
}

}  // namespace

TapWindows windowsOf(const TapParameters& parameters, double block_s, double width_s)
{
    if (parameters.window == TapWindow::None) return {};
    TapWindows windows;
    windows.decay_1_s = 1 / parameters.exponential_time_s.value_or(block_s / blocksPerDecay);
    windows.has_force = true;
    windows.force_window_s = parameters.force_window_s.value_or(pulsesInWindow * width_s);
    return windows;
}

double forceWindow(const TapWindows& windows, double time_s, double trigger_s)
{
    if (!windows.has_force) return 1;
    const double behind = time_s - trigger_s - windows.force_window_s;
    const double fall = 0.5 * windows.force_window_s;
    if (behind <= 0) return 1;
    return behind >= fall ? 0 : 0.5 * (1 + std::cos(std::numbers::pi * behind / fall));
}

TapSpectra spectraOf(const std::vector<TapSignals>& records, const FoundHits& found, const TapParameters& parameters,
                     const Progress& progress)
{
    const std::size_t samples = found.block.samples;
    const double rate = records.front().rate_hz;
    const signal::FourierTransform transform(samples);
    TapSpectra sums;
    sums.ff.assign(samples / 2 + 1, 0);
    sums.xx.assign(samples / 2 + 1, 0);
    sums.xf.assign(samples / 2 + 1, 0);
    std::vector<double> force(samples), motion(samples), medians(records.size());
    for (std::size_t r = 0; r < records.size(); ++r) medians[r] = medianOf(records[r].motion);
    for (const TapHit& hit : found.hits) {
        progress.report(static_cast<double>(&hit - found.hits.data()) / static_cast<double>(found.hits.size()));
        if (!hit.used) continue;
        const TapSignals& record = records[hit.record];
        const double trigger_s = static_cast<double>(hit.trigger - hit.first) / rate;
        const double width_s = static_cast<double>(hit.pulse_end - std::min(hit.pulse_end, hit.trigger)) / rate;
        const TapWindows windows = windowsOf(parameters, static_cast<double>(samples) / rate, width_s);
        const AtRest force_rest = restOf(record.force_N, hit, found.facts[hit.record].rest_N);
        const AtRest rest = restOf(record.motion, hit, medians[hit.record]);
        for (std::size_t i = 0; i < samples; ++i) {
            const double time_s = static_cast<double>(i) / rate;
            const double fall = std::exp(-windows.decay_1_s * time_s);
            force[i] =
                (record.force_N[hit.first + i] - force_rest.offset) * fall * forceWindow(windows, time_s, trigger_s);
            motion[i] = (record.motion[hit.first + i] - rest.offset) * fall;
        }
        bool is_noise = true;
        sums.left_percent += leftOf(motion, rest.noise, is_noise);
        sums.is_left_noise = sums.is_left_noise && is_noise;
        const auto f = transform.forward(force), x = transform.forward(motion);
        for (std::size_t k = 0; k < f.size(); ++k) {
            sums.ff[k] += std::norm(f[k]);
            sums.xx[k] += std::norm(x[k]);
            sums.xf[k] += x[k] * std::conj(f[k]);
        }
        ++sums.count;
        sums.windows.decay_1_s = windows.decay_1_s;
        sums.windows.has_force = windows.has_force;
        sums.windows.force_window_s = std::max(sums.windows.force_window_s, windows.force_window_s);
    }
    if (sums.count > 0) sums.left_percent /= static_cast<double>(sums.count);
    return sums;
}

}  // namespace lathelier::receptance
