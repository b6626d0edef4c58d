#include "engine/stability/simulation/simulation_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>

namespace lathelier::stability {
namespace {

constexpr int sampleRate_hz = 44100;
constexpr double endFade_s = 0.005;
constexpr double highestShare = 0.9;  ///< peak level over full scale
constexpr double fullScale = 32767;
constexpr std::size_t step_bytes = 1 << 16;

void addNumber(std::string& bytes, std::uint32_t number, int count)
{
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

std::string wavHead(std::uint32_t samples)
{
    std::string head = "RIFF";
    addNumber(head, 36 + 2 * samples, 4);
    head += "WAVEfmt ";
    addNumber(head, 16, 4);
    addNumber(head, 1, 2);  // PCM
    addNumber(head, 1, 2);  // mono
    addNumber(head, sampleRate_hz, 4);
    addNumber(head, 2 * sampleRate_hz, 4);  // bytes a second
    addNumber(head, 2, 2);                  // bytes of a sample
    addNumber(head, 16, 2);                 // bits of a sample
    head += "data";
    addNumber(head, 2 * samples, 4);
    return head;
}

/// Catmull-Rom interpolation; constant beyond the ends.
double smoothBetween(const std::vector<double>& values, double place)
{
    const auto last = static_cast<double>(values.size() - 1);
    const double whole = std::floor(std::clamp(place, 0.0, last));
    const double t = std::clamp(place, 0.0, last) - whole;
    const auto at = [&](double i) { return values[static_cast<std::size_t>(std::clamp(i, 0.0, last))]; };
    const double a = at(whole - 1), b = at(whole), c = at(whole + 1), d = at(whole + 2);
    return b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

}  // namespace

void writeWaveform(const SimulationResult& result, const std::function<void(std::string_view)>& append)
{
    std::string text = "time_s,deflection_mm,chip_thickness_mm\n";
    for (std::size_t i = 0; i < result.deflection_mm.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{},{},{}\n", static_cast<double>(i + 1) * result.step_s,
                       result.deflection_mm[i], result.chip_mm[i]);
        if (text.size() < step_bytes) continue;
        append(text);
        text.clear();
    }
    append(text);
}

double soundFullScale_mm(const SimulationResult& result)
{
    double largest = 0;
    for (const double x : result.deflection_mm) largest = std::max(largest, std::abs(x - result.static_deflection_mm));
    return largest / highestShare;
}

Sound soundOf(const SimulationResult& result)
{
    Sound sound;
    sound.full_scale_mm = soundFullScale_mm(result);
    sound.seconds = result.seconds();
    const double count = std::floor(sound.seconds * sampleRate_hz);
    const double scale = sound.full_scale_mm > 0 ? fullScale / sound.full_scale_mm : 0;
    const double fade = endFade_s * sampleRate_hz;
    sound.bytes = wavHead(static_cast<std::uint32_t>(count));
    sound.bytes.reserve(sound.bytes.size() + 2 * static_cast<std::size_t>(count));
    for (double i = 0; i < count; ++i) {
        const double to_end = std::clamp(std::min(i, count - 1 - i) / fade, 0.0, 1.0);
        const double loud = 0.5 - 0.5 * std::cos(std::numbers::pi * to_end);
        const double x = smoothBetween(result.deflection_mm, i / (sampleRate_hz * result.step_s) - 1);
        const double sample = std::clamp(scale * loud * (x - result.static_deflection_mm), -fullScale, fullScale);
        addNumber(sound.bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(sample))), 2);
    }
    return sound;
}

}  // namespace lathelier::stability
