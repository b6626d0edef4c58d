#include "engine/receptance/refined_lines.h"

#include <algorithm>
#include <cmath>

namespace lathelier::receptance {
namespace {

using Complex = std::complex<double>;

constexpr double tolerance = 1e-3;  ///< of the value at the middle of an interval, relative to |G|
constexpr int mostHalvings = 20;
constexpr std::size_t mostLines = 200000;

/// A value that is not defined (a free shaft at 0 Hz) is not approached.
bool isStraight(const Complex& before, const Complex& middle, const Complex& after, double share)
{
    const double size = std::max({std::abs(before), std::abs(middle), std::abs(after)});
    return !(std::abs(middle - 0.5 * (before + after)) > share * size);
}

/// Intervals (by their first line) whose ends are not straight over their neighbours: there the middle is tried.
/// Over two steps the deviation is four times that of the middle of one; half of that keeps a margin.
std::vector<std::size_t> curvedIntervals(const Frf& frf)
{
    constexpr double of_two_steps = 2;
    std::vector<char> is_open(frf.value.size(), 0);
    for (std::size_t i = 1; i + 1 < frf.value.size(); ++i) {
        if (isStraight(frf.value[i - 1], frf.value[i], frf.value[i + 1], of_two_steps * tolerance)) continue;
        is_open[i - 1] = is_open[i] = 1;
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i + 1 < is_open.size(); ++i)
        if (is_open[i]) open.push_back(i);
    return open;
}

}  // namespace

void refineLines(Frf& frf, const ValuesAt& values_at)
{
    std::vector<std::size_t> open = curvedIntervals(frf);
    for (int halving = 0; halving < mostHalvings && !open.empty(); ++halving) {
        if (frf.value.size() + open.size() > mostLines) return;
        std::vector<double> middles;
        middles.reserve(open.size());
        for (const std::size_t i : open) middles.push_back((frf.frequency_hz[i] + frf.frequency_hz[i + 1]) / 2);
        const std::vector<Complex> values = values_at(middles);
        Frf finer = frf;
        finer.frequency_hz.clear();
        finer.value.clear();
        std::vector<std::size_t> next;
        std::size_t k = 0;
        for (std::size_t i = 0; i < frf.value.size(); ++i) {
            finer.frequency_hz.push_back(frf.frequency_hz[i]);
            finer.value.push_back(frf.value[i]);
            if (k == open.size() || open[k] != i) continue;
            if (!isStraight(frf.value[i], values[k], frf.value[i + 1], tolerance)) {
                next.push_back(finer.value.size() - 1);
                finer.frequency_hz.push_back(middles[k]);
                finer.value.push_back(values[k]);
                next.push_back(finer.value.size() - 1);
            }
            ++k;
        }
        frf = std::move(finer);
        open = std::move(next);
    }
}

}  // namespace lathelier::receptance
