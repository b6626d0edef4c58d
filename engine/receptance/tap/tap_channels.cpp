#include "engine/receptance/tap/tap_channels.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"
#include "engine/receptance/tap/tap_codes.h"

namespace lathelier::receptance {
namespace {

using io::SignalUnit;
using io::TimeChannel;

constexpr double sameRate = 1e-6;  ///< relative

/// One of the two channels: how it is asked for, and what it may be.
struct Asked {
    TimeChannel::Role role;
    const std::string& choice;
    const std::string& sensitivity;
    const char* choice_key;
    const char* sensitivity_key;
    Text meaning;
    Text expected_unit;
    Text of_full_scale;
};

std::string channelName(const TimeChannel& channel)
{
    const std::string& name = channel.heading.empty() ? channel.name : channel.heading;
    return name.empty() ? std::string("#").append(std::to_string(channel.number)) : name;
}

std::string offeredChannels(const io::TimeRecord& record)
{
    constexpr std::size_t longest = 120;
    std::string words;
    for (const TimeChannel& channel : record.channels) {
        if (words.size() > longest) return words + " …";
        words += (words.empty() ? "" : ", ") + std::to_string(channel.number) + " " + channelName(channel);
    }
    return words;
}

bool isNamed(const TimeChannel& channel, const std::string& wanted)
{
    const std::string word = io::lowerCase(io::trimmed(wanted));
    return word == io::lowerCase(channel.heading) || word == io::lowerCase(channel.name);
}

const TimeChannel& statedChannel(const io::TimeRecord& record, const Asked& asked)
{
    std::vector<const TimeChannel*> found;
    const auto number = io::wholeInteger(io::trimmed(asked.choice));
    for (const TimeChannel& channel : record.channels)
        if (isNamed(channel, asked.choice) || (number && channel.number == *number)) found.push_back(&channel);
    if (found.size() == 1) return *found.front();
    throw Error(errors::valueNotUnderstood, {{"parameter", std::string(asked.choice_key)},
                                             {"found", asked.choice},
                                             {"expected", "one of the channels " + offeredChannels(record)}});
}

const TimeChannel& channelOf(const io::TimeRecord& record, const Asked& asked)
{
    if (!asked.choice.empty()) return statedChannel(record, asked);
    std::vector<const TimeChannel*> found;
    for (const TimeChannel& channel : record.channels)
        if (channel.role == asked.role) found.push_back(&channel);
    if (found.size() == 1) return *found.front();
    throw Error(
        errors::tapChannelUnclear,
        {{"meaning", asked.meaning}, {"found", offeredChannels(record)}, {"parameter", std::string(asked.choice_key)}});
}

/// Force or motion of one unit of the channel.
SignalUnit unitOf(const TimeChannel& channel, const Asked& asked, const TapChannels& channels, const std::string& path,
                  Notes& notes)
{
    const bool is_force = asked.role == TimeChannel::Role::Force;
    const auto fits = [is_force](const SignalUnit& unit) {
        return is_force ? unit.kind == SignalUnit::Kind::Force : unit.isMotion();
    };
    std::optional<io::Sensitivity> given;
    if (!asked.sensitivity.empty()) {
        given = io::sensitivityOf(asked.sensitivity);
        if (!given || !fits(given->per_unit))
            throw Error(errors::valueNotUnderstood, {{"parameter", std::string(asked.sensitivity_key)},
                                                     {"found", asked.sensitivity},
                                                     {"expected", asked.expected_unit}});
    }
    if (channel.unit && fits(*channel.unit)) {
        if (given)
            notes.push_back({notes::tapSensitivityNotUsed,
                             {{"path", path},
                              {"channel", channelName(channel)},
                              {"unit", channel.unit_text},
                              {"given", asked.sensitivity}}});
        return *channel.unit;
    }
    const bool is_voltage = channel.unit && channel.unit->kind == SignalUnit::Kind::Voltage;
    const bool is_foreign = (channel.unit && !is_voltage) || (!channel.unit && !channel.unit_text.empty());
    if (!given || is_foreign || (is_voltage && !given->of_volts))
        throw Error(errors::tapUnitMissing, {{"channel", channelName(channel)},
                                             {"found", channel.unit_text},
                                             {"expected", asked.expected_unit},
                                             {"parameter", std::string(asked.sensitivity_key)}});
    SignalUnit unit = given->per_unit;
    if (is_voltage) unit.scale *= channel.unit->scale;
    if (!channel.is_of_full_scale || !given->of_volts) return unit;
    if (!channels.full_scale_V)
        throw Error(errors::tapFullScaleMissing,
                    {{"channel", channelName(channel)}, {"expected", asked.of_full_scale}});
    unit.scale *= *channels.full_scale_V;
    return unit;
}

void requireSamples(const TimeChannel& channel)
{
    if (channel.missing_line == 0) return;
    throw Error(errors::tapSampleMissing, {{"line", channel.missing_line},
                                           {"column", channel.heading.empty() ? std::int64_t{1} : channel.number},
                                           {"channel", channelName(channel)}});
}

double rateOf(const TimeChannel& channel, const TapChannels& channels, const std::string& path, Notes& notes)
{
    if (!channel.rate_hz) {
        if (!channels.rate_hz) throw Error(errors::tapRateMissing, {});
        return *channels.rate_hz;
    }
    if (channels.rate_hz && std::abs(*channels.rate_hz - *channel.rate_hz) > sameRate * *channel.rate_hz)
        notes.push_back(
            {notes::tapRateNotUsed, {{"path", path}, {"rate_hz", *channel.rate_hz}, {"given_hz", *channels.rate_hz}}});
    return *channel.rate_hz;
}

void requireAlike(const TimeChannel& hammer, const TimeChannel& sensor)
{
    const auto differ = [&](double found, double expected, Text quantity) {
        return Error(
            errors::tapChannelsDiffer,
            {{"channel", channelName(sensor)}, {"found", found}, {"expected", expected}, {"quantity", quantity}});
    };
    if (hammer.values.size() != sensor.values.size())
        throw differ(static_cast<double>(sensor.values.size()), static_cast<double>(hammer.values.size()),
                     LT_TEXT("Engine", "samples"));
    if (!hammer.rate_hz || !sensor.rate_hz) return;
    if (std::abs(*hammer.rate_hz - *sensor.rate_hz) > sameRate * *hammer.rate_hz)
        throw differ(*sensor.rate_hz, *hammer.rate_hz, LT_TEXT("Engine", "samples a second"));
    if (std::abs(hammer.start_s - sensor.start_s) * *hammer.rate_hz > 0.01)
        throw differ(sensor.start_s, hammer.start_s, LT_TEXT("Engine", "seconds at the first sample"));
}

std::vector<double> inUnits(const TimeChannel& channel, double scale)
{
    std::vector<double> values;
    values.reserve(channel.values.size());
    for (const double value : channel.values) values.push_back(scale * value);
    return values;
}

FrfQuantity quantityOf(SignalUnit::Kind kind)
{
    if (kind == SignalUnit::Kind::Displacement) return FrfQuantity::Receptance;
    return kind == SignalUnit::Kind::Velocity ? FrfQuantity::Mobility : FrfQuantity::Accelerance;
}

int sided(const TimeChannel& channel)
{
    return channel.direction <= 3 ? channel.direction : 0;
}

TapMeasured takeBoth(const io::TimeRecord& record, const std::string& path, const TapChannels& channels, Notes& notes)
{
    const Asked force{TimeChannel::Role::Force,
                      channels.hammer,
                      channels.hammer_sensitivity,
                      "hammer",
                      "hammer-sensitivity",
                      LT_TEXT("Engine", "the hammer"),
                      LT_TEXT("Engine", "a force such as N, or a sensitivity such as 2.25 mV/N or 500 N"),
                      LT_TEXT("Engine", "500 N")};
    const Asked motion{TimeChannel::Role::Motion,
                       channels.response,
                       channels.response_sensitivity,
                       "response",
                       "response-sensitivity",
                       LT_TEXT("Engine", "the sensor"),
                       LT_TEXT("Engine", "a motion such as m/s^2, g, mm/s or um, or a sensitivity such as 100 mV/g"),
                       LT_TEXT("Engine", "50 g")};
    const TimeChannel& hammer = channelOf(record, force);
    const TimeChannel& sensor = channelOf(record, motion);
    if (&hammer == &sensor)
        throw Error(errors::valueNotUnderstood, {{"parameter", std::string("response")},
                                                 {"found", channelName(sensor)},
                                                 {"expected", LT_TEXT("Engine", "another channel than the hammer")}});
    const SignalUnit force_unit = unitOf(hammer, force, channels, path, notes);
    const SignalUnit motion_unit = unitOf(sensor, motion, channels, path, notes);
    requireSamples(hammer);
    requireSamples(sensor);
    requireAlike(hammer, sensor);
    TapMeasured taken;
    taken.quantity = quantityOf(motion_unit.kind);
    taken.hammer_node = hammer.node;
    taken.hammer_direction = sided(hammer);
    taken.response_node = sensor.node;
    taken.response_direction = sided(sensor);
    TapSignals& signals = taken.both;
    signals.path = path;
    signals.rate_hz = rateOf(hammer, channels, path, notes);
    signals.start_s = hammer.start_s;
    signals.force_N = inUnits(hammer, force_unit.scale);
    signals.motion = inUnits(sensor, motion_unit.scale);
    if (!hammer.at_limit.empty() || !sensor.at_limit.empty()) signals.at_limit.assign(signals.force_N.size(), 0);
    for (const std::size_t i : hammer.at_limit) signals.at_limit[i] = 1;
    for (const std::size_t i : sensor.at_limit) signals.at_limit[i] = static_cast<char>(signals.at_limit[i] | 2);
    return taken;
}

}  // namespace

const std::vector<Field<TapChannels>>& fieldsOf(const TapChannels*)
{
    using C = TapChannels;
    static const std::vector<Field<C>> all{
        field("hammer", &C::hammer,
              Label{LT_TEXT("Engine", "Hammer"),
                    LT_TEXT("Engine",
                            "Column or channel of the force, by name or number. Empty: the one in N or named so.")}),
        field("response", &C::response,
              Label{LT_TEXT("Engine", "Sensor"),
                    LT_TEXT("Engine",
                            "Column or channel of the motion, by name or number. Empty: the one in m/s², g, mm/s…")}),
        field("hammer_sensitivity", &C::hammer_sensitivity,
              Label{LT_TEXT("Engine", "Sensitivity of the hammer"),
                    LT_TEXT("Engine",
                            "Of a record in volts: 2.25 mV/N; or the force of one unit of the record: 500 N.")}),
        field("response_sensitivity", &C::response_sensitivity,
              Label{LT_TEXT("Engine", "Sensitivity of the sensor"),
                    LT_TEXT("Engine",
                            "Of a record in volts: 100 mV/g, 10 mV/(m/s^2); or the motion of one unit of the record: "
                            "50 g. Its unit tells what is measured.")}),
        field("full_scale_V", &C::full_scale_V, {1e-6, 1e6},
              Label{LT_TEXT("Engine", "Full scale"), LT_TEXT("Engine", "Voltage of the largest number of a WAV file."),
                    LT_TEXT("Engine", "V"), true}),
        field("rate_hz", &C::rate_hz, {1e-3, 1e9},
              Label{LT_TEXT("Engine", "Sampling rate"), LT_TEXT("Engine", "Of a record without times."),
                    LT_TEXT("Engine", "Hz"), true})};
    return all;
}

TapMeasured takeSignals(const io::TimeRecord& record, const std::string& path, const TapChannels& channels,
                        Notes& notes)
{
    try {
        return takeBoth(record, path, channels, notes);
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace lathelier::receptance
