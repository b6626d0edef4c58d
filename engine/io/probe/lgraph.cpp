// An L-Graph pair as a probe record: samples in frames, channels in volts.
#include "engine/io/probe/lgraph.h"

#include <cmath>
#include <cstring>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe/lgraph_header.h"
#include "engine/io/probe/probe_reader.h"

namespace lathelier::io {
namespace {

constexpr std::size_t framesPerTask = 1 << 16;

/// Full scale of the known recorders, at gain 1.
struct Device {
    std::string_view name;
    double code;
    double volts;
    bool is_assumed;  ///< determined from recordings, not from a manual
};
constexpr Device devices[] = {{"L783", 2000, 5, false}, {"L761", 8000, 5, true}};

/// Normalised device name: "L-783", "L 783" and "l783" are equal.
const Device* findDevice(const std::string& name)
{
    std::string plain;
    for (const char c : name)
        if (c != '-' && c != ' ' && c != '_') plain += static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c);
    for (const Device& device : devices)
        if (plain == device.name) return &device;
    return nullptr;
}

/// Volts per code at gain 1; none for an unknown recorder.
std::optional<double> voltsPerCode(const LGraphHeader& header, const RecorderOptions& options, Notes& notes)
{
    const Device* const device = findDevice(header.device);
    std::optional<double> code = options.full_scale_code;
    std::optional<double> volts = options.full_scale_V;
    if (device && !code && device->is_assumed)
        notes.push_back(
            {notes::fullScaleAssumed,
             {{"full_scale_code", device->code}, {"device", header.device}, {"volts", volts.value_or(device->volts)}}});
    if (device && !code) code = device->code;
    if (device && !volts) volts = device->volts;
    if (code && volts) return *volts / *code;
    notes.push_back({notes::fullScaleUnknown, {{"device", header.device}}});
    return std::nullopt;
}

/// Sampling delay between consecutive channels. The converter scans the channels of a frame at its rate; the stated
/// rate is used when it is consistent, else the frame is divided evenly.
double skewOf(const LGraphHeader& header, Notes& notes)
{
    const double channels = static_cast<double>(header.channels.size());
    const double needed_kHz = header.channel_kHz * channels;
    double converter_kHz = header.converter_kHz;
    if (!std::isfinite(converter_kHz) || converter_kHz < 0.99 * needed_kHz ||
        (header.version == LGraphVersion::Two && std::abs(converter_kHz - needed_kHz) > 0.01 * needed_kHz)) {
        notes.push_back({notes::converterRateWrong,
                         {{"stated_kHz", converter_kHz},
                          {"channels", static_cast<std::int64_t>(header.channels.size())},
                          {"used_kHz", needed_kHz}}});
        converter_kHz = needed_kHz;
    }
    const double skew_ms = 1 / converter_kHz;
    const auto isNear = [](double a, double b) { return std::abs(a - b) <= 0.02 * b; };
    // For some recorders the stated delay is the pause between two frames.
    const bool isPause = isNear((channels - 1) / converter_kHz + header.delay_ms, 1 / header.channel_kHz);
    if (!isNear(header.delay_ms, skew_ms) && !isPause)
        notes.push_back({notes::converterDelayDiffers, {{"stated_ms", header.delay_ms}, {"used_ms", skew_ms}}});
    return skew_ms / 1000;
}

void checkDatSize(const LGraphHeader& header, std::string_view dat, const std::string& datName)
{
    const auto channels = static_cast<std::int64_t>(header.channels.size());
    const auto found = static_cast<std::int64_t>(dat.size() / 2);
    const bool fits = dat.size() % 2 == 0 && found % channels == 0 && found / channels == header.frames;
    if (fits) return;
    if (found / channels < header.frames) {
        Error error(errors::truncated, {{"path", datName},
                                        {"byte", static_cast<std::int64_t>(dat.size())},
                                        {"found", found / channels},
                                        {"expected", header.frames},
                                        {"items", LT_TEXT("Engine", "frames")}});
        throw error;
    }
    throw recordContradicts(LT_TEXT("Engine", "size of the .dat file"), header.frames * channels * 2,
                            static_cast<std::int64_t>(dat.size()), header.frames * channels * 2)
        .with("path", datName);
}

std::vector<ProbeChannel> takeChannels(const LGraphHeader& header, std::string_view dat, std::optional<double> volts,
                                       const Progress& progress)
{
    const std::size_t count = header.channels.size();
    const auto frames = static_cast<std::size_t>(header.frames);
    std::vector<ProbeChannel> channels(count);
    std::vector<double> scales(count);
    for (std::size_t k = 0; k < count; ++k) {
        channels[k].name = "channel " + std::to_string(header.channels[k].number);
        channels[k].gain = header.channels[k].gain;
        channels[k].unit = volts ? ProbeChannel::Unit::Volt : ProbeChannel::Unit::Unknown;
        channels[k].values.resize(frames);
        scales[k] = volts.value_or(1) / channels[k].gain;
    }
    parallelFor(frames, framesPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            for (std::size_t k = 0; k < count; ++k) {
                std::int16_t code = 0;
                std::memcpy(&code, dat.data() + 2 * (f * count + k), 2);
                channels[k].values[f] = code * scales[k];
            }
    });
    return channels;
}

ProbeFile readPair(const std::string& name, std::string_view par, std::string_view dat, const std::string& datName,
                   const RecorderOptions& options, const Progress& progress)
{
    const LGraphHeader header = readLGraphHeader(par);
    checkDatSize(header, dat, datName);
    ProbeFile file;
    ProbeRecord record;
    record.name = name.substr(name.find_last_of('/') + 1);
    record.device = header.device;
    record.recorded = header.recorded;
    record.rate_hz = header.channel_kHz * 1000;
    record.channel_skew_s = skewOf(header, file.notes);
    record.channels = takeChannels(header, dat, voltsPerCode(header, options, file.notes), progress);
    if (header.segments > 1) file.notes.push_back({notes::recordInSegments, {{"count", header.segments}}});

    FileFacts& facts = file.facts;
    facts.path = name;
    facts.format = formatName(header.version);
    facts.rows = header.frames;
    facts.columns = static_cast<std::int64_t>(header.channels.size());
    std::string numbers;
    for (const LGraphChannel& channel : header.channels)
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(channel.number) +
                   (channel.gain > 1 ? " (gain " + std::to_string(channel.gain) + ")" : "");
    set(facts.details, "channels", facts.columns);
    set(facts.details, "channel_numbers", numbers);
    set(facts.details, "frames", header.frames);
    set(facts.details, "rate_kHz", header.channel_kHz);
    set(facts.details, "duration_s", header.total_s);
    set(facts.details, "device", header.device);
    set(facts.details, "recorded", header.recorded);
    set(facts.details, "channel_skew_us", *record.channel_skew_s * 1e6);
    for (Note& note : file.notes) set(note.values, "path", name);
    file.record = std::move(record);
    progress.report(1);
    return file;
}

}  // namespace

const std::vector<Field<RecorderOptions>>& fieldsOf(const RecorderOptions*)
{
    static const std::vector<Field<RecorderOptions>> all = {
        field(
            "full_scale_code", &RecorderOptions::full_scale_code, {1, 1e9},
            {LT_TEXT("Engine", "Full-scale code"),
             LT_TEXT("Engine", "Converter code of the full-scale voltage at gain 1; by default the recorder's own.")}),
        field("full_scale_V", &RecorderOptions::full_scale_V, {1e-6, 1e6},
              {LT_TEXT("Engine", "Full-scale voltage"),
               LT_TEXT("Engine", "Voltage of the full-scale code at gain 1; by default the recorder's own."),
               {"V"}}),
    };
    return all;
}

ProbeFile readLGraph(const std::string& name, std::string_view par, std::string_view dat,
                     const RecorderOptions& recorder, const Progress& progress, const std::string& datName)
{
    try {
        return readPair(name, par, dat, datName.empty() ? name : datName, recorder, progress);
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

}  // namespace lathelier::io
