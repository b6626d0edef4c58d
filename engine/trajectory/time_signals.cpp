#include <algorithm>
#include <cmath>

#include "engine/trajectory/record_plan.h"

namespace lathelier::trajectory {
namespace {

/// Minimum and maximum of each bucket, in their order, so that peaks are preserved.
void thin(TimeSignal& signal, const FrameClock& clock, const std::vector<double>& values, double factor, int limit)
{
    const std::size_t buckets = static_cast<std::size_t>(std::max(1, limit / 2));
    const std::size_t each = std::max<std::size_t>(1, (values.size() + buckets - 1) / buckets);
    for (std::size_t begin = 0; begin < values.size(); begin += each) {
        const std::size_t end = std::min(values.size(), begin + each);
        std::size_t least = begin, most = begin;
        for (std::size_t i = begin; i < end; ++i) {
            if (!(values[i] >= values[least])) least = i;
            if (!(values[i] <= values[most])) most = i;
        }
        const auto add = [&](std::size_t i) {
            signal.time_s.push_back(clock.time_s(i));
            signal.value.push_back(factor * values[i]);
        };
        add(std::min(least, most));
        if (least != most) add(std::max(least, most));
    }
}

}  // namespace

std::vector<TimeSignal> timeSignals(const io::ProbeRecord& record, const TrajectoryParameters& parameters, int limit,
                                    const Progress& progress)
{
    const FrameClock clock(record);
    std::vector<TimeSignal> signals(record.channels.size());
    std::vector<double> factor(record.channels.size(), 1);
    std::vector<double> starts_s;
    try {
        Notes notes;
        const ChannelMap map = mapChannels(record, parameters, notes);
        for (std::size_t probe = 0; probe < map.probes.size(); ++probe) {
            signals[map.probes[probe].channel].signal = name(static_cast<Probe>(probe));
            factor[map.probes[probe].channel] = map.probes[probe].um_per_value;
        }
        signals[map.reference].signal = map.is_angle ? "angle" : "marker";
        const double skew_s = parameters.channel_skew_s.value_or(record.channel_skew_s.value_or(0));
        for (const Revolution& revolution : findRevolutions(record, clock, map, parameters, skew_s).all)
            starts_s.push_back(revolution.start_s);
    } catch (const Error&) {
        // In recorded units: the plot serves to identify the channels.
    }
    for (std::size_t i = 0; i < signals.size(); ++i) {
        progress.report(static_cast<double>(i) / static_cast<double>(signals.size()));
        signals[i].channel = record.channels[i].name;
        signals[i].revolution_starts_s = starts_s;
        thin(signals[i], clock, record.channels[i].values, factor[i], limit);
    }
    return signals;
}

}  // namespace lathelier::trajectory
