#include "engine/receptance/eirc/spindle_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/receptance/eirc/spindle_lines.h"

namespace lathelier::receptance {
namespace {

constexpr std::array<double, 5> difference{1, -4, 6, -4, 1};
constexpr double squaresOfDifference = 70;
constexpr std::size_t differenceReach = 2;  // lines of a difference on either side
constexpr std::size_t fewestLines = 16;     // below them scatter says nothing
constexpr std::size_t linesOfNoise = 4;     // averaged on either side
constexpr double smallestShare = 1e-4;      // of the response: no measurement is surer
constexpr double smallestNoise = 1e-6;      // lower bound of (1-γ²)/γ², so that a coherence of 1 does not dominate
constexpr double smallestCoherence = 1e-6;  // coherence below which a response has no information
constexpr double outlierRatio = 4;          // |D|² beyond this multiple of its mean is a peak, not noise
constexpr int fittingRounds = 30;

bool hasCoherence(const Frf& frf)
{
    return frf.coherence.size() == frf.value.size();
}

/// |D|² about each line, without `differenceReach` lines at both ends.
std::vector<double> squaredDifferences(const Frf& frf)
{
    std::vector<double> squares;
    for (std::size_t i = differenceReach; i + differenceReach < frf.value.size(); ++i) {
        Complex sum = 0;
        for (std::size_t k = 0; k < difference.size(); ++k) sum += difference[k] * frf.value[i + k - differenceReach];
        squares.push_back(std::norm(sum));
    }
    return squares;
}

/// Σ c² of values by line, likewise.
std::vector<double> sumsOfSquares(const std::vector<double>& values)
{
    std::vector<double> sums;
    for (std::size_t i = differenceReach; i + differenceReach < values.size(); ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < difference.size(); ++k)
            sum += difference[k] * difference[k] * values[i + k - differenceReach];
        sums.push_back(sum);
    }
    return sums;
}

std::vector<double> squaredMagnitudes(const Frf& frf)
{
    std::vector<double> squares;
    for (const Complex& value : frf.value) squares.push_back(std::norm(value));
    return squares;
}

/// |A|² (1-γ²)/γ² by line, averaged.
std::vector<double> varianceByCoherence(const Frf& frf)
{
    std::vector<double> variance(frf.value.size());
    const auto of_line = [&frf](std::size_t i) {
        const double coherence = std::clamp(frf.coherence[i], smallestCoherence, 1.0);
        return std::norm(frf.value[i]) * std::max(smallestNoise, (1 - coherence) / coherence);
    };
    for (std::size_t i = 0; i < variance.size(); ++i) {
        if (!(frf.coherence[i] > smallestCoherence)) {
            variance[i] = HUGE_VAL;
            continue;
        }
        const std::size_t first = i > linesOfNoise ? i - linesOfNoise : 0;
        const std::size_t last = std::min(variance.size() - 1, i + linesOfNoise);
        double sum = 0;
        double count = 0;
        for (std::size_t k = first; k <= last; ++k) {
            if (!(frf.coherence[k] > smallestCoherence)) continue;
            sum += of_line(k);
            ++count;
        }
        variance[i] = sum / count;
    }
    return variance;
}

/// a² + b² x fitted to exponentially distributed y by weighted least squares, weights 1/mean².
std::array<double, 2> fittedVariance(const std::vector<double>& x, const std::vector<double>& y)
{
    double sum_x = 0;
    for (const double one : x) sum_x += one;
    const double mean_x = sum_x / static_cast<double>(x.size());
    std::vector<double> ratio;
    for (std::size_t i = 0; i < x.size(); ++i) ratio.push_back(y[i] / (mean_x + x[i]));
    double b = median(std::move(ratio)) / std::numbers::ln2;
    double a = b * mean_x;
    for (int i = 0; i < fittingRounds; ++i) {
        double w = 0, wx = 0, wxx = 0, wy = 0, wxy = 0;
        for (std::size_t k = 0; k < x.size(); ++k) {
            const double mean = a + b * x[k];
            if (!(mean > 0)) continue;
            const double weight = 1 / (mean * mean), value = std::min(y[k], outlierRatio * mean);
            w += weight;
            wx += weight * x[k];
            wxx += weight * x[k] * x[k];
            wy += weight * value;
            wxy += weight * x[k] * value;
        }
        const double determinant = w * wxx - wx * wx;
        if (!(determinant > 0)) break;
        a = (wxx * wy - wx * wxy) / determinant;
        b = (w * wxy - wx * wy) / determinant;
        if (a < 0) b = wxy / wxx;
        if (b < 0) a = wy / w;
        a = std::max(a, 0.0);
        b = std::max(b, 0.0);
    }
    return {a, b};
}

/// Of a response without coherence, in the square of what was measured.
std::vector<double> varianceByScatter(const Frf& frf)
{
    const std::vector<double> magnitude = squaredMagnitudes(frf);
    std::vector<double> y = squaredDifferences(frf), x = sumsOfSquares(magnitude);
    for (double& one : y) one /= squaresOfDifference;
    for (double& one : x) one /= squaresOfDifference;
    const auto [a, b] = fittedVariance(x, y);
    std::vector<double> variance;
    variance.reserve(magnitude.size());
    for (const double one : magnitude) variance.push_back(a + b * one);
    return variance;
}

/// What |D|² is of the variances stated by the coherence; 1 where nothing tells.
double scaleByScatter(const SpindleMeasurements& measurements, const std::vector<std::vector<double>>& variances)
{
    std::vector<double> ratio;
    for (std::size_t k = 0; k < variances.size(); ++k) {
        const Frf& frf = measurements.frfs[k].frf;
        if (!hasCoherence(frf)) continue;
        const std::vector<double> y = squaredDifferences(frf), x = sumsOfSquares(variances[k]);
        for (std::size_t i = 0; i < x.size(); ++i)
            if (x[i] > 0 && std::isfinite(x[i])) ratio.push_back(y[i] / x[i]);
    }
    return ratio.empty() ? 1 : median(std::move(ratio)) / std::numbers::ln2;
}

NoiseSource noiseSourceOf(const Frf& frf, int averages)
{
    if (hasCoherence(frf) && averages > 1) return NoiseSource::Averages;
    if (frf.value.size() < fewestLines) return NoiseSource::Unknown;
    return hasCoherence(frf) ? NoiseSource::Scaled : NoiseSource::Scatter;
}

}  // namespace

SpindleNoise spindleNoise(const SpindleMeasurements& measurements)
{
    SpindleNoise noise;
    noise.source = NoiseSource::Averages;
    std::vector<std::vector<double>> variances;
    for (const RodFrf& one : measurements.frfs) {
        const NoiseSource source = noiseSourceOf(one.frf, measurements.averages);
        noise.source = std::max(noise.source, source);
        if (hasCoherence(one.frf))
            variances.push_back(varianceByCoherence(one.frf));
        else
            variances.push_back(source == NoiseSource::Scatter ? varianceByScatter(one.frf)
                                                               : squaredMagnitudes(one.frf));
    }
    const double scale =
        measurements.averages > 1 ? 1.0 / (measurements.averages - 1) : scaleByScatter(measurements, variances);
    for (std::size_t k = 0; k < variances.size(); ++k) {
        const Frf& frf = measurements.frfs[k].frf;
        const double factor = hasCoherence(frf) ? scale : 1;
        std::vector<double>& sigma = noise.sigma_mm_N.emplace_back();
        for (std::size_t i = 0; i < frf.value.size(); ++i) {
            const double receptance = std::abs(measuredReceptance(frf, i)), size = std::abs(frf.value[i]);
            const bool is_known = size > 0 && std::isfinite(receptance) && frf.frequency_hz[i] > 0;
            const double share = std::max(smallestShare, std::sqrt(factor * variances[k][i]) / size);
            sigma.push_back(is_known && std::isfinite(share) ? share * receptance : HUGE_VAL);
        }
    }
    return noise;
}

const char* key(NoiseSource source)
{
    switch (source) {
        case NoiseSource::Averages: return "averages";
        case NoiseSource::Scaled: return "coherence";
        case NoiseSource::Scatter: return "scatter";
        case NoiseSource::Unknown: break;
    }
    return "unknown";
}

}  // namespace lathelier::receptance
