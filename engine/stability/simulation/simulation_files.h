// The waveform of a simulated cut as a table and as sound.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "engine/stability/simulation/simulation.h"

namespace lathelier::stability {

/// Columns time_s, deflection_mm, chip_thickness_mm, all digits, with a decimal point in every locale; passed to
/// `append` in chunks.
void writeWaveform(const SimulationResult& result, const std::function<void(std::string_view)>& append);

/// 16-bit PCM, mono, 44.1 kHz (RIFF WAVE). The vibration is the deflection less that of the steady cut, interpolated by
/// cubics; its largest value is scaled to 0.9 of full scale, and both ends are faded over 5 ms to avoid clicks.
struct Sound {
    std::string bytes;
    double full_scale_mm = 0;  ///< deflection of a sample of 32767
    double seconds = 0;        ///< duration
};
Sound soundOf(const SimulationResult& result);

/// Sound::full_scale_mm without making the sound.
double soundFullScale_mm(const SimulationResult& result);

}  // namespace lathelier::stability
