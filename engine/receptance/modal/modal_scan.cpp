#include "engine/receptance/modal/modal_scan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"

namespace lathelier::receptance {
namespace {

constexpr double narrowest = 0.7, widening = 1.6, widestShare = 0.2;  ///< half-widths in lines, share of all lines
constexpr double templateReach = 5;                                   ///< half-widths
constexpr double leastScanned = 1e-4, mostScanned = 0.4;              ///< damping ratios
constexpr std::size_t scatterLines = 40;                              ///< on each side

/// A response ready for filtering.
struct Filtered {
    std::vector<double> real, imag;  ///< w² (G - G_fit)
    std::vector<double> square;      ///< w²
};

Filtered filtered(const FitLines& lines, const Refined& fit, std::size_t response)
{
    Filtered all;
    const auto errors = weightedErrors(lines, fit, response);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        all.real.push_back(lines.weight[i] * errors[i].real());
        all.imag.push_back(lines.weight[i] * errors[i].imag());
        all.square.push_back(lines.weight[i] * lines.weight[i]);
    }
    return all;
}

/// 1/(i - x) over the lines around a mode.
struct Template {
    std::vector<double> real, imag, square;
    std::ptrdiff_t reach;
};

Template templateOf(double half_width)
{
    Template made{{}, {}, {}, static_cast<std::ptrdiff_t>(std::ceil(templateReach * half_width))};
    for (std::ptrdiff_t j = -made.reach; j <= made.reach; ++j) {
        const double x = static_cast<double>(j) / half_width, size = 1 / (1 + x * x);
        made.real.push_back(-x * size);
        made.imag.push_back(-size);
        made.square.push_back(size);
    }
    return made;
}

double gainAt(const Filtered& one, const Template& shape, std::ptrdiff_t centre, ResidueSign sign)
{
    const auto count = static_cast<std::ptrdiff_t>(one.square.size());
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, centre - shape.reach),
                         to = std::min(count - 1, centre + shape.reach);
    const auto start = static_cast<std::size_t>(from), offset = static_cast<std::size_t>(from - centre + shape.reach);
    double product = 0, size = 0;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(to - from); ++j) {
        product += shape.real[offset + j] * one.real[start + j] + shape.imag[offset + j] * one.imag[start + j];
        size += shape.square[offset + j] * one.square[start + j];
    }
    if (!(size > 0) || (sign == ResidueSign::Positive && product < 0)) return 0;
    return product * product / size;
}

/// Width of the lines around line `i`.
double stepAt(const FitLines& lines, std::size_t i)
{
    const std::size_t last = lines.frequency_hz.size() - 1, from = i > 0 ? i - 1 : 0, to = std::min(last, i + 1);
    return (lines.frequency_hz[to] - lines.frequency_hz[from]) / static_cast<double>(to - from);
}

/// Line of `lines` nearest to the frequency.
std::ptrdiff_t lineNear(const FitLines& lines, double frequency_hz)
{
    const auto& f = lines.frequency_hz;
    const auto above = std::lower_bound(f.begin(), f.end(), frequency_hz);
    if (above == f.end()) return static_cast<std::ptrdiff_t>(f.size()) - 1;
    if (above != f.begin() && frequency_hz - *(above - 1) < *above - frequency_hz) return above - f.begin() - 1;
    return above - f.begin();
}

}  // namespace

Candidate strongestMissing(std::span<const FitLines> lines, const Refined& fit, std::span<const ResidueSign> signs,
                           const Progress& progress)
{
    std::vector<Filtered> responses;
    for (std::size_t i = 0; i < lines.size(); ++i) responses.push_back(filtered(lines[i], fit, i));
    const FitLines& first = lines.front();
    const auto count = static_cast<double>(first.value.size());
    Candidate best;
    for (double half = narrowest; half < widestShare * count; half *= widening) {
        const Template shape = templateOf(half);
        const auto stride = static_cast<std::size_t>(std::max(1.0, half / 2));
        for (std::size_t i = 0; i < first.value.size(); i += stride) {
            if (lines.size() > 1) progress.check();
            const double f = first.frequency_hz[i];
            const double damping = half * stepAt(first, i) / f;
            if (damping < leastScanned || damping > mostScanned) continue;
            double gain = 0;
            for (std::size_t k = 0; k < responses.size(); ++k)
                gain += gainAt(responses[k], shape, k == 0 ? static_cast<std::ptrdiff_t>(i) : lineNear(lines[k], f),
                               signs[k]);
            if (gain > best.gain) best = {{f, damping}, gain};
        }
    }
    return best;
}

std::vector<double> scatterOf(const FitLines& lines, const Refined& fit, std::size_t response)
{
    const auto errors = weightedErrors(lines, fit, response);
    const std::size_t count = errors.size();
    std::vector<double> differences;  // from the cubic through the four neighbours, as variance of both parts together
    for (std::size_t i = 2; i + 2 < count; ++i)
        differences.push_back(std::norm(errors[i] - (errors[i - 1] + errors[i + 1]) * (2.0 / 3) +
                                        (errors[i - 2] + errors[i + 2]) * (1.0 / 6)) *
                              (18.0 / 35));
    std::vector<double> scatter(count, 1);
    if (differences.empty()) return scatter;
    std::vector<double> near;
    for (std::size_t i = 0; i < count; i += scatterLines) {  // piecewise constant
        const std::size_t from = i > scatterLines ? i - scatterLines : 0,
                          to = std::min(differences.size(), i + 2 * scatterLines);
        if (from >= to) break;
        near.assign(differences.begin() + static_cast<std::ptrdiff_t>(from),
                    differences.begin() + static_cast<std::ptrdiff_t>(to));
        // The median of an exponential distribution is ln 2 of its mean, which is twice the variance of one part.
        const double variance = upperMedianInPlace(near) / (2 * std::numbers::ln2);
        std::fill(scatter.begin() + static_cast<std::ptrdiff_t>(i),
                  scatter.begin() + static_cast<std::ptrdiff_t>(std::min(count, i + scatterLines)), variance);
    }
    return scatter;
}

}  // namespace lathelier::receptance
