#include "engine/io/frf/frf_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "engine/core/statistics.h"

namespace lathelier::io {
namespace {

constexpr std::size_t fewestLines = 9;
constexpr std::size_t averaged = 4;       ///< lines averaged on either side, with coherence and for proportional noise
constexpr std::size_t halfWindow = 20;    ///< fewest lines on either side of a knot of the fit over ln f
constexpr std::size_t widestWindow = 96;  ///< most lines on either side
constexpr double windowShare = 0.25;      ///< half width of the window as a share of the frequency
constexpr double outlier = 7;             ///< times the mean, which noise exceeds once in 1100
constexpr int passes = 16;
constexpr double steepest = 8;           ///< bound of the slope of ln variance over ln f
constexpr double leastCoherence = 1e-3;  ///< bound of γ²
constexpr double leastIncoherence = 1e-6,
                 roundedIncoherence = 1e-4;  ///< bounds of 1 - γ²: of any file, of four decimals
constexpr double telling = 1e-3;             ///< 1 - γ² above which a coherence is more than a rounded 1
constexpr std::size_t fewestTelling = 20;    ///< lines with it
constexpr double smoothedMinimum = 1.5;      ///< mean over the expected minimum of averages over nine lines
constexpr double leastRelativeNoise = 1e-9;  ///< rounding of files

/// Variance of each component by the difference from the neighbours' cubic; the first and last two lines have none.
std::vector<double> differences(const Frf& frf)
{
    const std::size_t count = frf.value.size();
    std::vector<double> variance(count, 0);
    for (std::size_t i = 2; i + 2 < count; ++i) {
        const std::array<std::size_t, 4> at{i - 2, i - 1, i + 1, i + 2};
        std::complex<double> predicted;
        double sum = 1;
        for (const std::size_t a : at) {
            double weight = 1;
            for (const std::size_t b : at)
                if (b != a)
                    weight *= (frf.frequency_hz[i] - frf.frequency_hz[b]) / (frf.frequency_hz[a] - frf.frequency_hz[b]);
            predicted += weight * frf.value[a];
            sum += weight * weight;
        }
        variance[i] = std::norm(frf.value[i] - predicted) / (2 * sum);
    }
    return variance;
}

/// A straight line of ln variance over ln f.
struct LogLine {
    double at = 0;     ///< ln f of the knot
    double value = 0;  ///< ln variance there
    double slope = 0;
};

/// Through the variances from `from` to `to` without those far above it. They are exponential variables: the line of
/// the greatest likelihood is found by Newton's method (scoring), from the median.
LogLine fitted(const std::vector<double>& log_f, const std::vector<double>& variance, std::size_t from, std::size_t to,
               double at)
{
    std::vector<double> sorted(variance.begin() + static_cast<std::ptrdiff_t>(from),
                               variance.begin() + static_cast<std::ptrdiff_t>(to));
    LogLine line{at, std::log(std::max(upperMedianInPlace(sorted) / std::log(2.0), 1e-300)), 0};
    for (int pass = 0; pass < passes; ++pass) {
        // The slope is not known in the first passes: more is let in.
        const double highest = pass < passes / 2 ? outlier * outlier : outlier;
        double n = 0, x = 0, r = 0, xx = 0, xr = 0;
        for (std::size_t i = from; i < to; ++i) {
            const double u = log_f[i] - at, ratio = variance[i] / std::exp(line.value + line.slope * u);
            if (!(ratio < highest)) continue;
            n += 1;
            x += u;
            xx += u * u;
            r += ratio - 1;
            xr += u * (ratio - 1);
        }
        const double determinant = n * xx - x * x;
        if (n < 4 || !(determinant > 1e-12 * n * xx)) break;
        line.slope =
            std::clamp(line.slope + std::clamp((n * xr - x * r) / determinant, -1.0, 1.0), -steepest, steepest);
        line.value += std::clamp((xx * r - x * xr) / determinant, -1.0, 1.0);
    }
    return line;
}

/// The slowly varying part of `variance`, by lines of ln variance over ln f in sliding windows.
std::vector<double> smoothed(const Frf& frf, const std::vector<double>& variance)
{
    const std::size_t count = frf.value.size();
    std::vector<double> log_f(count);
    for (std::size_t i = 0; i < count; ++i) log_f[i] = std::log(std::max(frf.frequency_hz[i], 1e-9));
    const std::size_t first = frf.frequency_hz[2] > 0 ? 2 : 3, last = count - 2;  // 0 Hz has no logarithm
    std::vector<LogLine> knots;
    for (std::size_t i = first;;) {
        std::size_t half = halfWindow;
        while (half < widestWindow && i + half < last &&
               frf.frequency_hz[i + half] < (1 + windowShare) * frf.frequency_hz[i])
            ++half;
        std::size_t from = i >= first + half ? i - half : first, to = std::min(last, i + half + 1);
        if (to - from < 2 * halfWindow) {  // at an end the window keeps its size
            if (from == first)
                to = std::min(last, from + 2 * halfWindow);
            else
                from = to >= first + 2 * halfWindow ? to - 2 * halfWindow : first;
        }
        knots.push_back(fitted(log_f, variance, from, to, log_f[i]));
        if (i + 1 >= last) break;
        i = std::min(i + half / 2, last - 1);
    }
    std::vector<double> result(count);
    std::size_t right = 0;
    for (std::size_t i = 0; i < count; ++i) {
        while (right + 1 < knots.size() && knots[right].at < log_f[i]) ++right;
        const std::size_t left = right > 0 ? right - 1 : 0;
        const auto valueBy = [&](const LogLine& line) { return line.value + line.slope * (log_f[i] - line.at); };
        const double span = knots[right].at - knots[left].at;
        const double share = span > 0 ? std::clamp((log_f[i] - knots[left].at) / span, 0.0, 1.0) : 1;
        result[i] = std::exp((1 - share) * valueBy(knots[left]) + share * valueBy(knots[right]));
    }
    return result;
}

/// Sums over `averaged` lines on either side.
std::vector<double> averages(const std::vector<double>& values)
{
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t from = i > averaged ? i - averaged : 0, to = std::min(values.size(), i + averaged + 1);
        double sum = 0;
        for (std::size_t j = from; j < to; ++j) sum += values[j];
        result[i] = sum / static_cast<double>(to - from);
    }
    return result;
}

/// Share b² of variance b²|G|² that no nine lines contradict.
double proportionalPart(const std::vector<double>& variance, const std::vector<double>& power)
{
    const std::vector<double> noise = averages(variance), signal = averages(power);
    double least = HUGE_VAL;
    for (std::size_t i = 2 + averaged; i + 2 + averaged < noise.size(); ++i)
        if (signal[i] > 0) least = std::min(least, noise[i] / signal[i]);
    return std::isfinite(least) ? smoothedMinimum * least : 0;
}

/// Variance by the coherence, with the factor of the differences; empty where the coherence says nothing.
std::vector<double> byCoherence(const Frf& frf, const std::vector<double>& power, const std::vector<double>& variance)
{
    double least = roundedIncoherence;  // what the file resolves
    for (const double one : frf.coherence)
        if (1 - one > 0) least = std::clamp(1 - one, leastIncoherence, least);
    std::vector<double> shape(frf.value.size());
    std::size_t tell = 0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const double incoherence = 1 - frf.coherence[i];
        tell += incoherence > telling ? 1 : 0;
        shape[i] = power[i] * std::max(least, incoherence) / std::max(leastCoherence, frf.coherence[i]);
    }
    if (tell < fewestTelling) return {};
    shape = averages(shape);
    std::vector<double> factors;
    for (std::size_t i = 2; i + 2 < shape.size(); ++i)
        if (1 - frf.coherence[i] > telling && shape[i] > 0) factors.push_back(variance[i] / shape[i]);
    if (factors.empty()) return {};
    const double factor = upperMedianInPlace(factors) / std::log(2.0);  // median of an exponential variable
    // Where the response is nothing but noise, its variance is that of the values.
    const std::vector<double> all = averages(power), level = smoothed(frf, power);
    for (std::size_t i = 0; i < shape.size(); ++i)
        shape[i] = std::min(shape[i] * factor, std::max(all[i], level[i]) / 2);
    return shape;
}

}  // namespace

std::vector<double> noiseOf(const Frf& frf)
{
    const std::size_t count = frf.value.size();
    if (count < fewestLines) return {};
    const std::vector<double> variance = differences(frf);
    std::vector<double> power(count);
    for (std::size_t i = 0; i < count; ++i) power[i] = std::norm(frf.value[i]);
    std::vector<double> noise = frf.coherence.empty() ? std::vector<double>() : byCoherence(frf, power, variance);
    if (noise.empty()) {
        noise = smoothed(frf, variance);
        const double share = proportionalPart(variance, power);
        for (std::size_t i = 0; i < count; ++i) noise[i] += share * power[i];
    }
    const double largest = *std::max_element(power.begin(), power.end());
    for (double& one : noise) one = std::sqrt(one + leastRelativeNoise * leastRelativeNoise * largest);
    return noise;
}

}  // namespace lathelier::io
