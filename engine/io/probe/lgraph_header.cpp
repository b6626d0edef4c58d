#include "engine/io/probe/lgraph_header.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "engine/io/io_codes.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {
namespace {

static_assert(std::endian::native == std::endian::little);  // the files are little endian

constexpr int mostChannels = 32;
constexpr std::size_t signatureBytes = 20;

struct Signature {
    std::string_view text;
    LGraphVersion version;
    std::size_t bytes;  ///< size of the .par; of L-Graph II the documented part
};

constexpr Signature signatures[] = {
    {"2571090,1618190", LGraphVersion::One, 223},
    {"2571090,1618190 A", LGraphVersion::After2008, 341},
    {"3571090,7859525", LGraphVersion::Two, 17135},
};

/// Offsets of the fields: those after the number of channels are wider since 2008.
struct Offsets {
    std::size_t frames, samples, total, converter, delay, channel_rate, active, gains;
};
constexpr Offsets narrowOffsets = {67, 71, 75, 83, 87, 91, 95, 159};
constexpr Offsets wideOffsets = {67, 75, 83, 93, 101, 109, 117, 277};
constexpr std::size_t channelsAt = 65;
constexpr std::size_t secondFramesAt = 227;  ///< offset of the number of frames in L-Graph II
constexpr std::size_t segmentsAt = 17131;

template <class T>
T lgraphValueAt(std::string_view bytes, std::size_t offset)
{
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

/// An 80-bit x87 number: 64 bits of mantissa, 15 of exponent, sign.
double extendedAt(std::string_view bytes, std::size_t offset)
{
    const auto mantissa = lgraphValueAt<std::uint64_t>(bytes, offset);
    const auto top = lgraphValueAt<std::uint16_t>(bytes, offset + 8);
    const int exponent = (top & 0x7FFF) - 16383 - 63;
    const double size = (top & 0x7FFF) == 0x7FFF ? std::nan("") : std::ldexp(static_cast<double>(mantissa), exponent);
    return (top & 0x8000) != 0 ? -size : size;
}

/// Text in a field of fixed width: up to the first NUL, without blanks and line ends around it.
std::string fieldText(std::string_view bytes, std::size_t offset, std::size_t width)
{
    std::string_view field = bytes.substr(offset, width);
    field = field.substr(0, field.find('\0'));
    const auto isFilling = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    while (!field.empty() && isFilling(field.front())) field.remove_prefix(1);
    while (!field.empty() && isFilling(field.back())) field.remove_suffix(1);
    return excerpt(decodeText(field, Encoding::Auto).view());
}

const Signature* findSignature(std::string_view par)
{
    if (par.size() < signatureBytes) return nullptr;
    std::string_view text = par.substr(0, signatureBytes);
    text = text.substr(0, text.find('\0'));
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    for (const Signature& signature : signatures)
        if (text == signature.text) return &signature;
    return nullptr;
}

std::int64_t byteOf(std::size_t offset)
{
    return static_cast<std::int64_t>(offset);
}

/// Checks that a number is finite and > 0.
double positive(double value, Text check, std::size_t offset)
{
    if (std::isfinite(value) && value > 0) return value;
    throw recordContradicts(check, byteOf(offset), value, LT_TEXT("Engine", "a number above 0"));
}

void readNarrow(std::string_view par, LGraphHeader& header, std::int64_t& samples)
{
    header.frames = lgraphValueAt<std::int32_t>(par, narrowOffsets.frames);
    samples = lgraphValueAt<std::int32_t>(par, narrowOffsets.samples);
    header.total_s = lgraphValueAt<double>(par, narrowOffsets.total);
    header.converter_kHz = static_cast<double>(lgraphValueAt<float>(par, narrowOffsets.converter));
    header.delay_ms = static_cast<double>(lgraphValueAt<float>(par, narrowOffsets.delay));
    header.channel_kHz = static_cast<double>(lgraphValueAt<float>(par, narrowOffsets.channel_rate));
}

void readWide(std::string_view par, LGraphHeader& header, std::int64_t& samples)
{
    header.frames = lgraphValueAt<std::int64_t>(par, wideOffsets.frames);
    samples = lgraphValueAt<std::int64_t>(par, wideOffsets.samples);
    header.total_s = extendedAt(par, wideOffsets.total);
    header.converter_kHz = lgraphValueAt<double>(par, wideOffsets.converter);
    header.delay_ms = lgraphValueAt<double>(par, wideOffsets.delay);
    header.channel_kHz = lgraphValueAt<double>(par, wideOffsets.channel_rate);
}

/// The channels whose flag is set, in ascending order; their number must agree with the header.
void readChannels(std::string_view par, const Offsets& offsets, LGraphHeader& header)
{
    const int count = lgraphValueAt<std::int16_t>(par, channelsAt);
    if (count < 1 || count > mostChannels)
        throw recordContradicts(LT_TEXT("Engine", "number of channels"), byteOf(channelsAt), std::int64_t{count},
                                LT_TEXT("Engine", "1 to 32"));
    const bool areWide = header.version == LGraphVersion::After2008;
    for (std::size_t k = 0; k < mostChannels; ++k) {
        const bool active = areWide ? lgraphValueAt<std::int32_t>(par, offsets.active + 4 * k) != 0
                                    : lgraphValueAt<std::uint8_t>(par, offsets.active + k) != 0;
        if (!active) continue;
        const auto code = lgraphValueAt<std::uint8_t>(par, offsets.gains + k);
        if (code > 3)
            throw recordContradicts(LT_TEXT("Engine", "gain code"), byteOf(offsets.gains + k), std::int64_t{code},
                                    LT_TEXT("Engine", "0 to 3"));
        header.channels.push_back({static_cast<int>(k) + 1, 1 << code});
    }
    if (header.channels.size() != static_cast<std::size_t>(count))
        throw recordContradicts(LT_TEXT("Engine", "active channels"), byteOf(offsets.active),
                                static_cast<std::int64_t>(header.channels.size()), std::int64_t{count});
}

void checkCounts(std::string_view par, const Offsets& offsets, std::int64_t samples, const LGraphHeader& header)
{
    const auto channels = static_cast<std::int64_t>(header.channels.size());
    if (header.frames < 1)
        throw recordContradicts(LT_TEXT("Engine", "frames"), byteOf(offsets.frames), header.frames,
                                LT_TEXT("Engine", "a number above 0"));
    if (samples % channels != 0 || samples / channels != header.frames)
        throw recordContradicts(LT_TEXT("Engine", "samples = frames × channels"), byteOf(offsets.samples), samples,
                                static_cast<double>(header.frames) * static_cast<double>(channels));
    if (header.version != LGraphVersion::Two) return;
    const auto again = lgraphValueAt<std::int64_t>(par, secondFramesAt);
    if (again != header.frames)
        throw recordContradicts(LT_TEXT("Engine", "frames, stated twice"), byteOf(secondFramesAt), again,
                                header.frames);
}

void checkTimes(const Offsets& offsets, const LGraphHeader& header)
{
    const double frames = static_cast<double>(header.frames);
    const double expected_s = frames / (header.channel_kHz * 1000);
    if (std::abs(header.total_s - expected_s) > std::max(1e-3 * expected_s, 1.5 * expected_s / frames))
        throw recordContradicts(LT_TEXT("Engine", "total time = frames / rate"), byteOf(offsets.total), header.total_s,
                                expected_s);
    // L-Graph II is known to state a wrong converter rate.
    const double needed_kHz = header.channel_kHz * static_cast<double>(header.channels.size());
    if (header.version != LGraphVersion::Two && !(header.converter_kHz >= 0.99 * needed_kHz))
        throw recordContradicts(LT_TEXT("Engine", "converter rate ≥ rate × channels"), byteOf(offsets.converter),
                                header.converter_kHz, needed_kHz);
}

}  // namespace

bool hasLGraphSignature(std::string_view par)
{
    return findSignature(par) != nullptr;
}

std::string formatName(LGraphVersion version)
{
    switch (version) {
        case LGraphVersion::One: return "lgraph_1";
        case LGraphVersion::After2008: return "lgraph_2008";
        case LGraphVersion::Two: return "lgraph_2";
    }
    return {};
}

Error recordContradicts(Text check, std::int64_t byte, Value found, Value expected)
{
    return Error(errors::recordContradicts,
                 {{"byte", byte}, {"check", check}, {"found", std::move(found)}, {"expected", std::move(expected)}});
}

LGraphHeader readLGraphHeader(std::string_view par)
{
    if (par.empty()) throw Error(errors::fileEmpty, {});
    const Signature* const signature = findSignature(par);
    if (!signature)
        throw Error(errors::formatUnknown, {{"byte", std::int64_t{0}},
                                            {"found", LT_TEXT("Engine", "another signature")},
                                            {"expected", LT_TEXT("Engine", "the .par file of an L-Graph record")}});
    if (par.size() < signature->bytes)
        throw Error(errors::truncated, {{"byte", byteOf(par.size())},
                                        {"found", byteOf(par.size())},
                                        {"expected", byteOf(signature->bytes)},
                                        {"items", LT_TEXT("Engine", "bytes")}});
    if (signature->version != LGraphVersion::Two && par.size() > signature->bytes)
        throw recordContradicts(LT_TEXT("Engine", "size of the .par file"), byteOf(signature->bytes),
                                byteOf(par.size()), byteOf(signature->bytes));
    LGraphHeader header;
    header.version = signature->version;
    header.device = fieldText(par, 20, 17);
    header.recorded = fieldText(par, 37, 26);
    const bool isWide = header.version == LGraphVersion::After2008;
    const Offsets& offsets = isWide ? wideOffsets : narrowOffsets;
    readChannels(par, offsets, header);
    std::int64_t samples = 0;
    (isWide ? readWide : readNarrow)(par, header, samples);
    checkCounts(par, offsets, samples, header);
    positive(header.channel_kHz, LT_TEXT("Engine", "rate per channel"), offsets.channel_rate);
    positive(header.total_s, LT_TEXT("Engine", "total time"), offsets.total);
    checkTimes(offsets, header);
    if (header.version == LGraphVersion::Two) header.segments = lgraphValueAt<std::int32_t>(par, segmentsAt);
    return header;
}

}  // namespace lathelier::io
