#include "engine/trajectory/channel_map.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "engine/core/core_codes.h"
#include "engine/io/text/number.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

constexpr std::array<const char*, 4> probeNames{"X3", "Y3", "Xp", "Yp"};

/// The signals of a map: the four probes in the order of Probe, then marker and angle.
constexpr std::array<const char*, 6> signalNames{"X3", "Y3", "Xp", "Yp", "marker", "angle"};
constexpr std::size_t markerSignal = 4;
constexpr std::size_t angleSignal = 5;

struct Entry {
    bool given = false;
    bool turned = false;
    std::string channel;  ///< index or name of the channel
    std::size_t column = 1;
};
using Entries = std::array<Entry, signalNames.size()>;

bool same(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

[[noreturn]] void reject(std::string_view found, std::size_t column, Value expected)
{
    throw Error(errors::valueNotUnderstood, {{"parameter", "channels"},
                                             {"found", std::string(found)},
                                             {"expected", std::move(expected)},
                                             {"column", static_cast<std::int64_t>(column)}});
}

Entries parseMap(std::string_view map)
{
    Entries entries;
    std::size_t begin = 0;
    while (begin <= map.size()) {
        const std::size_t end = std::min(map.find(',', begin), map.size());
        const std::string_view whole = map.substr(begin, end - begin);
        std::string_view left = trimmed(whole);
        const std::size_t equals = left.find('=');
        if (equals == std::string_view::npos)
            reject(left, begin + 1, LT_TEXT("Engine", "signal=channel, such as X3=1"));
        Entry entry;
        entry.given = true;
        entry.column = begin + 1;
        entry.channel = std::string(trimmed(left.substr(equals + 1)));
        left = trimmed(left.substr(0, equals));
        entry.turned = left.starts_with('-');
        if (entry.turned) left = trimmed(left.substr(1));
        const auto signal = std::find_if(signalNames.begin(), signalNames.end(),
                                         [&](std::string_view candidate) { return same(candidate, left); });
        if (signal == signalNames.end()) reject(left, entry.column, "marker | angle | X3 | Y3 | Xp | Yp");
        Entry& place = entries[static_cast<std::size_t>(signal - signalNames.begin())];
        if (place.given) reject(trimmed(whole), entry.column, LT_TEXT("Engine", "each signal once"));
        if (entry.channel.empty())
            reject(trimmed(whole), entry.column, LT_TEXT("Engine", "signal=channel, such as X3=1"));
        place = entry;
        begin = end + 1;
    }
    for (std::size_t signal = 0; signal < markerSignal; ++signal)
        if (!entries[signal].given) reject(map, 1, std::string(signalNames[signal]) + "=…");
    if (entries[markerSignal].given == entries[angleSignal].given) reject(map, 1, "marker=… | angle=…");
    return entries;
}

/// Channels of a record whose headings say which signal they are.
std::optional<Entries> byHeadings(const io::ProbeRecord& record)
{
    Entries entries;
    for (std::size_t signal = 0; signal < signalNames.size(); ++signal)
        for (std::size_t channel = 0; channel < record.channels.size(); ++channel)
            if (!entries[signal].given && same(record.channels[channel].name, signalNames[signal]))
                entries[signal] = {true, false, std::to_string(channel), 1};
    for (std::size_t signal = 0; signal < markerSignal; ++signal)
        if (!entries[signal].given) return std::nullopt;
    if (entries[markerSignal].given) entries[angleSignal] = {};
    return entries[markerSignal].given || entries[angleSignal].given ? std::optional(entries) : std::nullopt;
}

std::size_t placeOf(const io::ProbeRecord& record, const Entry& entry, const char* signal)
{
    const auto unknown = [&](Text reason) -> Error {
        return Error(errors::channelsUnknown, {{"signal", signal},
                                               {"found", entry.channel},
                                               {"reason", reason},
                                               {"channels", static_cast<std::int64_t>(record.channels.size())}});
    };
    if (const auto place = io::wholeInteger(entry.channel)) {
        if (*place < 0 || *place >= static_cast<std::int64_t>(record.channels.size()))
            throw unknown(LT_TEXT("Engine", "there is no such channel"));
        return static_cast<std::size_t>(*place);
    }
    for (std::size_t channel = 0; channel < record.channels.size(); ++channel)
        if (same(record.channels[channel].name, entry.channel)) return channel;
    throw unknown(LT_TEXT("Engine", "no channel has this name"));
}

double toMicrometres(const io::ProbeRecord& record, std::size_t channel, const char* signal,
                     double sensitivity_um_per_V)
{
    switch (record.channels[channel].unit) {
        case io::ProbeChannel::Unit::Micrometre: return 1;
        case io::ProbeChannel::Unit::Millimetre: return 1000;
        case io::ProbeChannel::Unit::Volt: return sensitivity_um_per_V;
        case io::ProbeChannel::Unit::Unknown:
            throw Error(errors::channelUnitMissing, {{"signal", signal},
                                                     {"found", static_cast<std::int64_t>(channel)},
                                                     {"channel", record.channels[channel].name}});
        case io::ProbeChannel::Unit::Degree: break;
    }
    throw Error(errors::channelsUnknown, {{"signal", signal},
                                          {"found", static_cast<std::int64_t>(channel)},
                                          {"reason", LT_TEXT("Engine", "it holds angles, not displacements")},
                                          {"channels", static_cast<std::int64_t>(record.channels.size())}});
}

/// A disconnected probe yields a constant value, one out of range its limit value repeatedly. Limit for the latter: a
/// coarsely quantised sinusoid is at its peak for a few per cent of the time.
void noteStandstill(const io::ProbeChannel& channel, const char* signal, Notes& notes)
{
    constexpr double clippedShare = 0.1;
    if (channel.values.empty()) return;
    const auto [low, high] = std::minmax_element(channel.values.begin(), channel.values.end());
    if (*low == *high) {
        notes.push_back({notes::channelStandsStill, {{"signal", signal}, {"channel", channel.name}}});
        return;
    }
    const auto count = static_cast<double>(channel.values.size());
    for (const double end : {*low, *high}) {
        const double share = static_cast<double>(std::count(channel.values.begin(), channel.values.end(), end)) / count;
        if (share > clippedShare)
            notes.push_back({notes::channelCutOff,
                             {{"signal", signal}, {"channel", channel.name}, {"share_percent", 100 * share}}});
    }
}

using SensitivityOfProbes = std::array<std::optional<double>, 4>;

SensitivityOfProbes sensitivities(const std::vector<ProbeCalibration>& probes)
{
    SensitivityOfProbes result;
    for (const ProbeCalibration& probe : probes) {
        std::optional<double>& place = result[static_cast<std::size_t>(probe.probe)];
        if (place)
            throw Error(errors::valueNotUnderstood, {{"parameter", "probes"},
                                                     {"found", name(probe.probe)},
                                                     {"expected", LT_TEXT("Engine", "each probe once")}});
        place = probe.sensitivity_um_per_V;
    }
    return result;
}

}  // namespace

const char* name(Probe probe)
{
    return probeNames[static_cast<std::size_t>(probe)];
}

ChannelMap mapChannels(const io::ProbeRecord& record, const TrajectoryParameters& parameters, Notes& notes)
{
    Entries entries = parseMap(parameters.channels);
    if (parameters.channels == TrajectoryParameters{}.channels)
        if (const auto named = byHeadings(record)) entries = *named;
    ChannelMap map;
    const std::size_t reference = entries[angleSignal].given ? angleSignal : markerSignal;
    map.reference = placeOf(record, entries[reference], signalNames[reference]);
    const io::ProbeChannel::Unit unit = record.channels[map.reference].unit;
    map.is_angle = reference == angleSignal || unit == io::ProbeChannel::Unit::Degree;
    if (map.is_angle && unit != io::ProbeChannel::Unit::Degree && unit != io::ProbeChannel::Unit::Unknown)
        throw Error(errors::channelsUnknown, {{"signal", signalNames[reference]},
                                              {"found", static_cast<std::int64_t>(map.reference)},
                                              {"reason", LT_TEXT("Engine", "it holds no angles")},
                                              {"channels", static_cast<std::int64_t>(record.channels.size())}});
    const SensitivityOfProbes calibrated = sensitivities(parameters.probes);
    UsedValues used;
    const double common = resolve<TrajectoryParameters>(used, "sensitivity_um_per_V", parameters.sensitivity_um_per_V,
                                                        {}, assumedSensitivity_um_per_V);
    bool uses_common = false;
    for (std::size_t probe = 0; probe < map.probes.size(); ++probe) {
        const Entry& entry = entries[probe];
        ProbePlace& place = map.probes[probe];
        place.channel = placeOf(record, entry, signalNames[probe]);
        for (std::size_t other = 0; other <= probe; ++other)
            if (place.channel == (other == probe ? map.reference : map.probes[other].channel))
                reject(std::string(signalNames[probe]) + "=" + entry.channel, entry.column,
                       LT_TEXT("Engine", "each channel once"));
        const bool in_volts = record.channels[place.channel].unit == io::ProbeChannel::Unit::Volt;
        uses_common = uses_common || (in_volts && !calibrated[probe]);
        place.um_per_value =
            toMicrometres(record, place.channel, signalNames[probe], calibrated[probe].value_or(common)) *
            (entry.turned ? -1 : 1);
        noteStandstill(record.channels[place.channel], signalNames[probe], notes);
    }
    if (!uses_common) return map;
    map.used = used;
    if (!parameters.sensitivity_um_per_V)
        notes.push_back({notes::sensitivityAssumed, {{"sensitivity_um_per_V", assumedSensitivity_um_per_V}}});
    return map;
}

}  // namespace lathelier::trajectory
