#include "engine/receptance/usable_lines.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/receptance/usable_codes.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t sustained = 5;  ///< consecutive lines
constexpr double aboveNoise = 4;      ///< |G| over the standard deviation of each component
constexpr std::size_t fewestLines = 4;

}  // namespace

UsedLines linesAboveNoise(const Frf& frf)
{
    const std::size_t count = frf.frequency_hz.size();
    UsedLines used;
    if (count == 0) return used;
    used.range_hz = {frf.frequency_hz.front(), frf.frequency_hz.back()};
    if (frf.noise.size() != count) return used;
    std::size_t first = count, last = 0, run = 0;
    for (std::size_t i = 0; i < count; ++i) {
        run = std::abs(frf.value[i]) > aboveNoise * frf.noise[i] ? run + 1 : 0;
        if (run < sustained) continue;
        first = std::min(first, i + 1 - sustained);
        last = i;
    }
    used.is_all_noise = first == count;
    if (used.is_all_noise) return used;
    used.range_hz = {frf.frequency_hz[first], frf.frequency_hz[last]};
    used.left_out = static_cast<std::int64_t>(count - (last + 1 - first));
    return used;
}

UsedLines keepLines(Frf& frf, const Interval& range_hz)
{
    const auto begin = std::lower_bound(frf.frequency_hz.begin(), frf.frequency_hz.end(), range_hz.from);
    const auto end = std::upper_bound(frf.frequency_hz.begin(), frf.frequency_hz.end(), range_hz.to);
    if (end - begin < static_cast<std::ptrdiff_t>(fewestLines))
        throw Error(errors::rangeWithoutLines,
                    {{"from_hz", range_hz.from},
                     {"to_hz", range_hz.to},
                     {"found", static_cast<std::int64_t>(std::max<std::ptrdiff_t>(0, end - begin))},
                     {"first_hz", frf.frequency_hz.empty() ? 0 : frf.frequency_hz.front()},
                     {"last_hz", frf.frequency_hz.empty() ? 0 : frf.frequency_hz.back()}});
    const auto from = static_cast<std::size_t>(begin - frf.frequency_hz.begin());
    const auto to = static_cast<std::size_t>(end - frf.frequency_hz.begin());
    UsedLines used{{frf.frequency_hz[from], frf.frequency_hz[to - 1]},
                   static_cast<std::int64_t>(frf.frequency_hz.size() - (to - from)),
                   false};
    const auto keep = [&](auto& list) {
        if (list.empty()) return;
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(to), list.end());
        list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(from));
    };
    keep(frf.frequency_hz);
    keep(frf.value);
    keep(frf.coherence);
    keep(frf.noise);
    return used;
}

UsedLines takeUsableLines(Frf& frf, const std::vector<Interval>& asked_hz, const std::string& path, Notes& notes)
{
    if (asked_hz.size() > 1)
        throw Error(errors::valueNotUnderstood, {{"parameter", "range_hz"},
                                                 {"found", Value(asked_hz)},
                                                 {"expected", LT_TEXT("Engine", "one range of frequencies")}});
    if (!asked_hz.empty()) return keepLines(frf, asked_hz.front());
    const UsedLines above = linesAboveNoise(frf);
    if (above.is_all_noise) notes.push_back({notes::nothingAboveNoise, {{"path", path}}});
    if (above.is_all_noise || above.left_out == 0) return above;
    const UsedLines used = keepLines(frf, above.range_hz);
    notes.push_back(
        {notes::linesOfNoiseLeftOut,
         {{"path", path}, {"count", used.left_out}, {"from_hz", used.range_hz.from}, {"to_hz", used.range_hz.to}}});
    return used;
}

}  // namespace lathelier::receptance
