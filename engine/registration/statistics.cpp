#include "engine/registration/statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t valuesPerTask = 65536;

/// Bits in the order of the values.
std::uint32_t ordered(float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

/// A round number (1, 2, 5 × 10^k) not below `width`.
double roundUp(double width)
{
    const double power = std::pow(10, std::floor(std::log10(width)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= width * (1 - 1e-12)) return factor * power;
    return 10 * power;
}

}  // namespace

std::vector<double> quantiles(std::span<const float> values, const std::vector<double>& shares)
{
    std::vector<double> result;
    if (values.empty()) return std::vector<double>(shares.size(), notANumber);
    std::vector<std::size_t> counts(
        65536);  // by the upper half of the bits; each quantile then looks at one such group
    for (const float v : values) ++counts[ordered(v) >> 16];
    struct Wanted {
        std::size_t rank;  // within the group
        std::uint32_t group = 0;
        std::vector<float> members = {};
    };
    std::vector<Wanted> wanted;
    for (const double share : shares) {
        Wanted own{std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))};
        while (own.rank >= counts[own.group]) own.rank -= counts[own.group++];
        own.members.reserve(counts[own.group]);
        wanted.push_back(std::move(own));
    }
    for (const float v : values)
        for (Wanted& own : wanted)
            if (ordered(v) >> 16 == own.group) own.members.push_back(v);
    for (Wanted& own : wanted) {
        const auto place = own.members.begin() + static_cast<std::ptrdiff_t>(own.rank);
        std::nth_element(own.members.begin(), place, own.members.end());
        result.push_back(*place);
    }
    return result;
}

DeviationStatistics summarise(std::span<const float> values, const Progress& progress)
{
    DeviationStatistics s;
    s.points_used = static_cast<std::int64_t>(values.size());
    struct Totals {
        double sum = 0, squares = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    };
    const Totals sums = parallelReduce(
        values.size(), valuesPerTask, progress, Totals{},
        [&](std::size_t begin, std::size_t end) {
            Totals part;
            for (std::size_t i = begin; i < end; ++i) {
                const double v = values[i];
                part.sum += v;
                part.squares += v * v;
                part.low = std::min(part.low, v);
                part.high = std::max(part.high, v);
            }
            return part;
        },
        [](Totals all, const Totals& part) {
            return Totals{all.sum + part.sum, all.squares + part.squares, std::min(all.low, part.low),
                          std::max(all.high, part.high)};
        });
    const auto n = static_cast<double>(values.size());
    const bool any = !values.empty();
    s.mean_mm = any ? sums.sum / n : notANumber;
    s.rmse_mm = any ? std::sqrt(sums.squares / n) : notANumber;
    s.std_mm = any ? std::sqrt(std::max(0.0, sums.squares / n - s.mean_mm * s.mean_mm)) : notANumber;
    s.min_mm = any ? sums.low : notANumber;
    s.max_mm = any ? sums.high : notANumber;

    const auto offFrom = [&](double middle, double share) {
        std::vector<float> off(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) off[i] = std::abs(values[i] - static_cast<float>(middle));
        return quantiles(off, {share})[0];
    };
    parallelFor(2, 1, progress, [&](std::size_t task, std::size_t) {
        if (task == 0) {
            const std::vector<double> own = quantiles(values, {0.025, 0.5, 0.975});
            s.p2_5_mm = own[0];
            s.median_mm = own[1];
            s.p97_5_mm = own[2];
            s.mad_sigma_mm = madToSigma * offFrom(s.median_mm, 0.5);
        } else {
            s.p95_abs_mm = offFrom(0, 0.95);
        }
    });
    return s;
}

Histogram histogramOf(std::span<const float> values, const Progress& progress)
{
    Histogram histogram;
    if (values.empty()) return histogram;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const std::vector<double> middle = quantiles(values, {0.25, 0.75});
    const double range = static_cast<double>(*high) - *low;
    // The rule of Freedman and Diaconis would give thousands of bins for a scan; a sixteenth of the interquartile range
    // is used instead.
    const double fine = (middle[1] - middle[0]) / 16;
    // Bins narrower than the spacing of floats are useless, and their edges would be rounded.
    const double resolution = std::numeric_limits<float>::epsilon() * std::max(std::abs(*low), std::abs(*high));
    const double width = roundUp(std::max({fine, range / 498, resolution, 1e-9}));
    const double first = std::floor(*low / width);
    const auto bins = static_cast<std::size_t>(std::floor(*high / width) - first) + 1;
    histogram.counts = parallelReduce(
        values.size(), valuesPerTask, progress, std::vector<std::int64_t>(bins),
        [&](std::size_t begin, std::size_t end) {
            std::vector<std::int64_t> part(bins);
            for (std::size_t i = begin; i < end; ++i)
                ++part[std::min(bins - 1,
                                static_cast<std::size_t>(std::max(0.0, std::floor(values[i] / width) - first)))];
            return part;
        },
        [](std::vector<std::int64_t> all, const std::vector<std::int64_t>& part) {
            for (std::size_t i = 0; i < all.size(); ++i) all[i] += part[i];
            return all;
        });
    for (std::size_t i = 0; i <= bins; ++i) histogram.edges_mm.push_back((first + static_cast<double>(i)) * width);
    return histogram;
}

}  // namespace lathelier::registration
