#include <bit>
#include <cmath>
#include <cstring>

#include "engine/io/io_codes.h"
#include "engine/io/time_record/time_record_formats.h"

namespace lathelier::io {
namespace {

constexpr std::size_t riffHeader_bytes = 12;
constexpr std::size_t chunkHeader_bytes = 8;
constexpr std::uint32_t unknownSize = 0xFFFFFFFF;
constexpr std::uint32_t integerFormat = 1, floatFormat = 3, extensibleFormat = 0xFFFE;
constexpr std::uint32_t mostWavChannels = 256;

std::uint32_t littleEndian(std::string_view bytes, std::size_t at, std::size_t count)
{
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < count; ++k)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    return value;
}

Error wavMalformed(std::size_t byte, Value found, Text expected)
{
    return Error(errors::malformed,
                 {{"byte", static_cast<std::int64_t>(byte)}, {"found", std::move(found)}, {"expected", expected}});
}

Error wavTruncated(std::size_t byte, std::size_t found, std::size_t expected)
{
    return Error(errors::truncated, {{"byte", static_cast<std::int64_t>(byte)},
                                     {"found", static_cast<std::int64_t>(found)},
                                     {"expected", static_cast<std::int64_t>(expected)},
                                     {"items", LT_TEXT("Engine", "bytes of a chunk")}});
}

struct WavFormat {
    bool is_float = false;
    std::size_t channels = 0;
    std::size_t sample_bytes = 0;
    std::uint32_t rate_hz = 0;
};

WavFormat readWavFormat(std::string_view bytes, std::size_t at, std::size_t size)
{
    constexpr std::size_t plain = 16, extensible = 26;
    if (size < plain) throw wavTruncated(at, size, plain);
    std::uint32_t format = littleEndian(bytes, at, 2);
    if (format == extensibleFormat && size >= extensible) format = littleEndian(bytes, at + 24, 2);
    const std::uint32_t channels = littleEndian(bytes, at + 2, 2), rate = littleEndian(bytes, at + 4, 4),
                        bits = littleEndian(bytes, at + 14, 2);
    const bool is_known =
        (format == integerFormat && (bits == 16 || bits == 24 || bits == 32)) || (format == floatFormat && bits == 32);
    if (!is_known)
        throw wavMalformed(at, "format " + std::to_string(format) + ", " + std::to_string(bits) + " bits",
                           LT_TEXT("Engine", "whole numbers of 16, 24 or 32 bits, or floating point of 32 bits"));
    if (channels == 0 || channels > mostWavChannels)
        throw wavMalformed(at + 2, std::int64_t{channels}, LT_TEXT("Engine", "a number of channels, 1 to 256"));
    if (rate == 0) throw wavMalformed(at + 4, std::int64_t{rate}, LT_TEXT("Engine", "a rate in samples a second"));
    return {format == floatFormat, channels, bits / 8, rate};
}

double wavSample(std::string_view bytes, std::size_t at, const WavFormat& format)
{
    const std::uint32_t raw = littleEndian(bytes, at, format.sample_bytes);
    if (format.is_float) return static_cast<double>(std::bit_cast<float>(raw));
    const auto shift = static_cast<std::uint32_t>(32 - 8 * format.sample_bytes);
    return static_cast<double>(std::bit_cast<std::int32_t>(raw << shift)) * 0x1p-31;
}

TimeRecord wavChannels(std::string_view bytes, std::size_t at, std::size_t size, const WavFormat& format,
                       const Progress& progress)
{
    constexpr std::size_t framesPerCheck = 1 << 16;
    const std::size_t frame = format.channels * format.sample_bytes;
    const std::size_t frames = size / frame;
    // The largest number of a converter is one step below full scale.
    const double highest = 1 - std::ldexp(1.0, 1 - static_cast<int>(8 * format.sample_bytes));
    TimeRecord record;
    for (std::size_t c = 0; c < format.channels; ++c) {
        TimeChannel& channel = record.channels.emplace_back();
        channel.number = static_cast<std::int64_t>(c) + 1;
        channel.is_of_full_scale = true;
        channel.rate_hz = format.rate_hz;
        channel.values.reserve(frames);
        for (std::size_t i = 0; i < frames; ++i) {
            if (i % framesPerCheck == 0) progress.report(static_cast<double>(c) / static_cast<double>(format.channels));
            const double value = wavSample(bytes, at + i * frame + c * format.sample_bytes, format);
            if (!std::isfinite(value))
                throw wavMalformed(at + i * frame + c * format.sample_bytes, LT_TEXT("Engine", "no number"),
                                   LT_TEXT("Engine", "a finite sample"));
            if (!format.is_float && (value >= highest || value <= -1)) channel.at_limit.push_back(i);
            channel.values.push_back(value);
        }
    }
    return record;
}

}  // namespace

bool isWav(std::string_view head)
{
    return head.size() >= riffHeader_bytes && head.starts_with("RIFF") && head.substr(8, 4) == "WAVE";
}

TimeRecordFile readWav(std::string_view bytes, const Progress& progress)
{
    std::optional<WavFormat> format;
    std::size_t at = riffHeader_bytes;
    while (at + chunkHeader_bytes <= bytes.size()) {
        const std::string_view id = bytes.substr(at, 4);
        const std::uint32_t stated = littleEndian(bytes, at + 4, 4);
        at += chunkHeader_bytes;
        const std::size_t there = bytes.size() - at;
        const bool is_data = id == "data";
        const std::size_t size = is_data && (stated == unknownSize || stated == 0) ? there : stated;
        if (size > there) throw wavTruncated(bytes.size(), there, size);
        if (id == "fmt ") format = readWavFormat(bytes, at, size);
        if (is_data) {
            if (!format) throw wavMalformed(at, "data", LT_TEXT("Engine", "the chunk “fmt ” before the samples"));
            TimeRecordFile file;
            file.record = wavChannels(bytes, at, size, *format, progress);
            file.facts.format = "WAV";
            file.facts.rows = static_cast<std::int64_t>(file.record.channels.front().values.size());
            file.facts.columns = static_cast<std::int64_t>(format->channels);
            set(file.facts.details, "bits", static_cast<std::int64_t>(8 * format->sample_bytes));
            set(file.facts.details, "floating_point", format->is_float);
            return file;
        }
        at += size + size % 2;
    }
    throw wavMalformed(bytes.size(), LT_TEXT("Engine", "the end of the file"), LT_TEXT("Engine", "the chunk “data”"));
}

}  // namespace lathelier::io
