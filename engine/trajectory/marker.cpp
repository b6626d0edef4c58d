#include "engine/trajectory/marker.h"

#include <algorithm>
#include <cmath>

namespace lathelier::trajectory {
namespace {

constexpr double middleShare = 0.2;  ///< share of values in the middle half of the range above which the signal is not
                                     ///< a marker
constexpr double rareEnds = 0.001;   ///< share of values at either end ignored as spikes when the range is determined

double valueAtRank(std::span<double> values, std::size_t rank)
{
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace

MarkerLevels findMarkerLevels(std::span<const double> values)
{
    MarkerLevels levels;
    std::vector<double> known;
    known.reserve(values.size());
    std::copy_if(values.begin(), values.end(), std::back_inserter(known), [](double v) { return std::isfinite(v); });
    if (known.size() < 8) {
        levels.complaint = LT_TEXT("Engine", "it has hardly any values");
        return levels;
    }
    const std::size_t ends = std::min<std::size_t>(
        3 + static_cast<std::size_t>(rareEnds * static_cast<double>(known.size())), known.size() / 4);
    const double bottom = valueAtRank(known, ends);
    const double top = valueAtRank(known, known.size() - 1 - ends);
    // A single short pulse may be rejected as spikes: then the full range is used.
    const auto [least, most] = std::minmax_element(known.begin(), known.end());
    if (*least == *most) {
        levels.complaint = LT_TEXT("Engine", "it stands still");
        return levels;
    }
    const bool hidden = top - bottom < 0.5 * (*most - *least);
    const double from = hidden ? *least : bottom;
    const double to = hidden ? *most : top;
    const double middle = (from + to) / 2;
    const auto between =
        std::count_if(known.begin(), known.end(), [&](double v) { return std::abs(v - middle) < 0.25 * (to - from); });
    // In place, since the marker of a long record is large.
    const auto split = std::partition(known.begin(), known.end(), [middle](double v) { return v < middle; });
    const std::span<double> below(known.begin(), split);
    const std::span<double> above(split, known.end());
    // Edges occupy part of a short pulse: its level is taken near its extreme, not at its median.
    constexpr std::size_t farEnd = 5;
    levels.high_is_rare = above.size() <= below.size();
    levels.low = valueAtRank(below, levels.high_is_rare ? below.size() / 2 : below.size() / farEnd);
    levels.high = valueAtRank(above, levels.high_is_rare ? above.size() - 1 - above.size() / farEnd : above.size() / 2);
    levels.threshold = (levels.low + levels.high) / 2;
    if (static_cast<double>(between) > middleShare * static_cast<double>(known.size()))
        levels.complaint = LT_TEXT("Engine", "it does not rest on two levels, as a marker does");
    return levels;
}

std::vector<double> findMarks(std::span<const double> values, const FrameClock& clock, const MarkerLevels& levels)
{
    std::vector<double> marks_s;
    const double sign = levels.high_is_rare ? 1 : -1;
    const double rest = sign * (levels.high_is_rare ? levels.low : levels.high);
    const double threshold = sign * levels.threshold;
    const double armed_below = (threshold + rest) / 2;
    bool armed = false;  // false at first: a record may start within a pulse
    std::size_t last = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double v = sign * values[i];
        if (!std::isfinite(v)) continue;
        if (armed && v >= threshold) {
            const double before = sign * values[last];
            const double share = (threshold - before) / (v - before);
            marks_s.push_back(clock.time_s(last) + share * (clock.time_s(i) - clock.time_s(last)));
            armed = false;
        } else if (v < armed_below) {
            armed = true;
        }
        last = i;
    }
    return marks_s;
}

}  // namespace lathelier::trajectory
