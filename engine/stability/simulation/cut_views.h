// Views of a simulated cut: the two waves of any revolution, the machined surface, the spectrum.
#pragma once

#include "engine/report/chart.h"
#include "engine/stability/simulation/simulation.h"

namespace lathelier::stability {

/// Whole waves between two revolutions and the phase of the regeneration, of f = n (m + ε/2π), n the speed in 1/s.
struct WavePhase {
    int whole = 0;         ///< m; lobe m is the limiting one
    double phase_deg = 0;  ///< ε, 0 to 360; orthogonal chatter lies between 180 and 360
    double fraction = 0;  ///< ν = ε/2π - 1 for ε above 180°, else ε/2π: its sign gives the inclination of the marks
    double period_mm = 0;  ///< of the marks along the axis, f/|ν|; infinite where ν = 0
};

WavePhase phaseOf(double frequency_hz, double speed_rpm, double feed_mm_rev);

/// Number of whole revolutions of the waveform.
int revolutionsOf(const SimulationResult& result);

/// Outer and inner wave of one revolution, from 0 to revolutionsOf(result) - 1; clamped to these.
WavePair wavesOf(const SimulationResult& result, int revolution);

/// Surface of earlier revolutions and path of the tool, unrolled, with the chip between them; whole waves and phase in
/// the remark.
report::Plot wavesPlot(const SimulationResult& result, const WavePair& waves, const Language& language = {});

/// The turned surface unrolled: angle across, the axis upwards, height over that of the steady cut in µm; of the
/// revolutions up to and with `last`, at most `revolutions` of them.
report::ColourMap surfaceMap(const SimulationResult& result, int last, int revolutions = 40);

/// Amplitude of the vibration in each revolution, and that of linear growth, with which it agrees until the tool leaves
/// the cut.
report::Plot amplitudePlot(const SimulationResult& result);

/// Amplitude of the deflection over the frequency, of the last half of the waveform (Hann's window), up to
/// `highest_hz`; the frequency of the dominant vibration is marked.
report::Plot spectrumPlot(const SimulationResult& result, double highest_hz, const Language& language = {});

}  // namespace lathelier::stability
