// Real-time simulation of a cut with variable speed and depth, for audio output.
//
// The equation is that of simulation.h, with the surface stored over time: the wave in front of the tool is the one cut
// T = 60/N ago. Changes of speed and depth are smoothed over some hundredths of a second, and the deflection follows
// its equation of motion, so that the sound is continuous. Noise on the chip thickness excites the modes, as otherwise
// no vibration would start.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/stability/modes.h"
#include "engine/stability/simulation/mode_step.h"

namespace lathelier::stability {

struct StreamParameters {
    double speed_rpm = 2000;                  ///< N, ≥ least_rpm
    double depth_mm = 0.2;                    ///< a
    double cutting_coefficient_N_mm2 = 2000;  ///< K_r
    double feed_mm_rev = 0.1;                 ///< h₀
    double direction_factor = 1;              ///< D: the oriented receptance is D·G
    double noise_percent = 1;                 ///< standard deviation of the chip thickness, in percent of the feed
};

/// One cut. Deterministic: equal calls give equal samples.
class CutStream {
public:
    static constexpr double least_rpm = 30;  ///< slower speeds are raised to this one

    /// Preconditions: at least one mode, a rate that gives the highest mode eight samples in a period.
    CutStream(const std::vector<Mode>& modes, const StreamParameters& parameters, double sample_rate_hz);

    /// Changes speed and depth smoothly within some hundredths of a second. Feed, coefficient and direction are
    /// unchanged.
    void moveTo(double speed_rpm, double depth_mm);

    /// Next samples of the deflection without its steady part, divided by the feed.
    void fill(std::span<float> samples);

private:
    double noise();
    double surfaceBefore(double samples) const;

    StreamParameters wanted_;
    double rate_hz_;
    ModeSteps constants_;
    std::vector<double> deflection_, speed_;
    std::vector<double> surface_;  ///< ring buffer of the cut surface of the last seconds
    std::size_t now_ = 0;          ///< write position in surface_
    double speed_rpm_, depth_mm_;  ///< current values, approaching the targets
    double force_ = 0;
    double steady_ = 0;  ///< mean of the deflection
    std::uint64_t random_ = 0x853c49e6748fea9bULL;
};

/// Audio signal of a sequence of cuts, with loudness normalisation and limiting to full scale.
class CutSound {
public:
    explicit CutSound(double sample_rate_hz = 44100) : rate_hz_(sample_rate_hz) {}

    /// Cross-fades to another part or machine.
    void take(const std::vector<Mode>& modes, const StreamParameters& parameters);
    void moveTo(double speed_rpm, double depth_mm);
    bool hasCut() const { return !streams_.empty(); }

    /// The next samples, within ±1, `volume` 0 to 1, smoothed. Silence without a cut.
    void fill(std::span<float> samples, double volume);

private:
    struct Voice {
        CutStream stream;
        double share = 0;  ///< gain of a voice, approaching 1 for the last voice and 0 for the others
    };

    double rate_hz_;
    std::vector<Voice> streams_;
    std::vector<float> part_;  ///< samples of one voice
    double loud_ = 0;          ///< running mean magnitude of the signal
    double volume_ = 0;        ///< current volume, approaching the requested one
};

}  // namespace lathelier::stability
