#include "engine/receptance/modal/modal_weights.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/io/frf/frf_noise.h"

namespace lathelier::receptance {
namespace {

constexpr double floorShare = 0.03;  ///< lower bound of σ as share of the median, without coherence
constexpr double leastSigma = 1e-9;  ///< lower bound of σ as share of |G| and of the median: rounding in files
constexpr double modelShare = 3e-4;  ///< of |G|, added to the noise: no modal model describes a response better

double medianSize(const FitLines& lines)
{
    std::vector<double> sizes;
    sizes.reserve(lines.value.size());
    for (const auto& value : lines.value) sizes.push_back(std::abs(value));
    return upperMedianInPlace(sizes);
}

}  // namespace

FitLines linesToFit(const Frf& frf, const Interval& range_hz)
{
    const std::vector<double> noise = frf.noise.empty() && !frf.coherence.empty() ? io::noiseOf(frf) : frf.noise;
    FitLines lines;
    std::vector<double> sigma;
    for (std::size_t i = 0; i < frf.frequency_hz.size(); ++i) {
        const double f = frf.frequency_hz[i];
        if (!(f > 0) || f < range_hz.from || f > range_hz.to || !std::isfinite(std::abs(frf.value[i]))) continue;
        lines.frequency_hz.push_back(f);
        lines.value.push_back(frf.value[i]);
        if (!noise.empty()) sigma.push_back(noise[i]);
    }
    if (lines.value.empty()) return lines;
    const double median = medianSize(lines);
    lines.weight.reserve(lines.value.size());
    for (std::size_t i = 0; i < lines.value.size(); ++i) {
        const double size = std::abs(lines.value[i]);
        const double one = sigma.empty() ? size + floorShare * median : std::hypot(sigma[i], modelShare * size);
        lines.weight.push_back(1 / std::max(one, leastSigma * median + 1e-300));
    }
    return lines;
}

void reweigh(FitLines& lines, const Refined& fit, std::size_t response)
{
    const std::size_t count = lines.value.size();
    std::vector<double> error(count), size(count);
    double all = 0, sizes = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::complex<double> fitted = valueOf(fit.poles, fit.responses[response], lines.frequency_hz[i]);
        error[i] = std::norm(lines.value[i] - fitted);
        size[i] = std::norm(fitted);
        all += error[i];
        sizes += size[i];
    }
    const auto n = static_cast<double>(count);
    const double median = medianSize(lines), least = leastSigma * leastSigma;
    double floor = all / n / 2, share = all / sizes / 2;  // a² and b² of σ² = a² + b²|G|²
    for (int pass = 0; pass < 20; ++pass) {
        double ww = 0, wg = 0, gg = 0, we = 0, ge = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double sigma2 = floor + share * size[i] + least * (size[i] + median * median);
            const double w = 1 / (sigma2 * sigma2);
            ww += w;
            wg += w * size[i];
            gg += w * size[i] * size[i];
            we += w * error[i];
            ge += w * error[i] * size[i];
        }
        const double determinant = ww * gg - wg * wg;
        double a2 = (we * gg - ge * wg) / determinant, b2 = (ww * ge - wg * we) / determinant;
        if (!(determinant > 1e-12 * ww * gg) || !(a2 >= 0)) a2 = 0, b2 = ge / gg;
        if (b2 < 0) b2 = 0, a2 = we / ww;
        floor = a2;
        share = b2;
    }
    for (std::size_t i = 0; i < count; ++i)
        lines.weight[i] = 1 / std::sqrt(floor + share * size[i] + least * (size[i] + median * median));
}

}  // namespace lathelier::receptance
