// L-Graph recordings of all three versions, made byte by byte.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace lathelier::testing {

enum class Made { One, After2008, Two };

/// What goes into a .par; everything fits together until a test changes it.
struct LGraphSetup {
    Made version = Made::One;
    std::string device = "L783";
    std::vector<int> active = {1, 3, 4};  ///< physical channels
    std::vector<int> gain_codes = std::vector<int>(32, 0);
    std::int64_t frames = 100;
    double channel_kHz = 10;
    double converter_kHz = 30;
    double delay_ms = 1.0 / 30;
};

template <class T>
void put(std::string& bytes, std::size_t offset, T value)
{
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

inline void putText(std::string& bytes, std::size_t offset, const std::string& text)
{
    std::memcpy(bytes.data() + offset, text.data(), text.size());
}

/// An x87 number of 10 bytes, as the PC's own arithmetic stores it.
inline void putExtended(std::string& bytes, std::size_t offset, long double value)
{
    static_assert(sizeof(long double) == 16);
    std::memcpy(bytes.data() + offset, &value, 10);
}

inline std::string makePar(const LGraphSetup& setup)
{
    const bool wide = setup.version == Made::After2008;
    std::string par(setup.version == Made::Two ? 33929 : wide ? 341 : 223, '\0');
    const char* const signatures[] = {"2571090,1618190", "2571090,1618190 A", "3571090,7859525  "};
    putText(par, 0, signatures[static_cast<int>(setup.version)]);
    putText(par, 20, setup.device);
    putText(par, 37, "Tue Apr 21 12:00:00 2015\n");
    const auto channels = static_cast<std::int16_t>(setup.active.size());
    const std::int64_t samples = setup.frames * channels;
    const double total_s = static_cast<double>(setup.frames) / setup.channel_kHz / 1000;
    put<std::int16_t>(par, 63, 32);
    put<std::int16_t>(par, 65, channels);
    if (wide) {
        put<std::int64_t>(par, 67, setup.frames);
        put<std::int64_t>(par, 75, samples);
        putExtended(par, 83, total_s);
        put<double>(par, 93, setup.converter_kHz);
        put<double>(par, 101, setup.delay_ms);
        put<double>(par, 109, setup.channel_kHz);
    } else {
        put<std::int32_t>(par, 67, static_cast<std::int32_t>(setup.frames));
        put<std::int32_t>(par, 71, static_cast<std::int32_t>(samples));
        put<double>(par, 75, total_s);
        put<float>(par, 83, static_cast<float>(setup.converter_kHz));
        put<float>(par, 87, static_cast<float>(setup.delay_ms));
        put<float>(par, 91, static_cast<float>(setup.channel_kHz));
    }
    for (const int channel : setup.active) {
        const auto k = static_cast<std::size_t>(channel - 1);
        if (wide)
            put<std::int32_t>(par, 117 + 4 * k, 1);
        else
            put<std::uint8_t>(par, 95 + k, 1);
    }
    for (std::size_t k = 0; k < 32; ++k)
        put<std::uint8_t>(par, (wide ? 277 : 159) + k, static_cast<std::uint8_t>(setup.gain_codes[k]));
    if (setup.version == Made::Two) {
        put<std::int32_t>(par, 223, 3);
        put<std::int64_t>(par, 227, setup.frames);
        put<std::int32_t>(par, 17131, 1);
    }
    return par;
}

/// Sample f of channel c is 100·f - c: every place in the file has a value of its own.
inline std::string makeDat(std::int64_t frames, std::size_t channels)
{
    std::string dat(static_cast<std::size_t>(frames) * channels * 2, '\0');
    for (std::size_t f = 0; f < static_cast<std::size_t>(frames); ++f)
        for (std::size_t c = 0; c < channels; ++c)
            put<std::int16_t>(dat, 2 * (f * channels + c), static_cast<std::int16_t>(100 * f - c));
    return dat;
}

}  // namespace lathelier::testing
