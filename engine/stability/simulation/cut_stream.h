// A cut that goes on, sample by sample, while its speed and depth are changed: what is heard.
//
// The equation is that of simulation.h, with the surface kept over the time: what stands before the tool now is what it
// left T = 60/N ago. A change of speed or depth glides over some hundredths of a second, and the deflection follows
// from its equation of motion, so that the sound never jumps. The chip tears unevenly: a small noise of the chip
// thickness excites the modes, for without it nothing would ever begin to grow.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/stability/modes.h"
#include "engine/stability/simulation/mode_step.h"

namespace lathelier::stability {

struct StreamParameters {
    double speed_rpm = 2000;                  ///< N, 30 and above
    double depth_mm = 0.2;                    ///< a
    double cutting_coefficient_N_mm2 = 2000;  ///< K_r
    double feed_mm_rev = 0.1;                 ///< h₀
    double direction_factor = 1;              ///< D: the oriented receptance is D·G
    double noise_percent = 1;                 ///< standard deviation of the chip thickness, of the feed
};

/// One cut. Same calls, same samples.
class CutStream {
public:
    static constexpr double least_rpm = 30;  ///< slower speeds are taken for this one

    /// Preconditions: at least one mode, a rate that gives the highest mode eight samples in a period.
    CutStream(const std::vector<Mode>& modes, const StreamParameters& parameters, double sample_rate_hz);

    /// Goes there within some hundredths of a second. Feed, coefficient and direction stay.
    void moveTo(double speed_rpm, double depth_mm);

    /// The deflection without its steady part, over the feed, for the next samples.
    void fill(std::span<float> samples);

private:
    double noise();
    double surfaceBefore(double samples) const;

    StreamParameters wanted_;
    double rate_hz_;
    ModeSteps constants_;
    std::vector<double> deflection_, speed_;  ///< of each mode
    std::vector<double> surface_;             ///< what the tool left, the last seconds of it, round about
    std::size_t now_ = 0;                     ///< where the next one goes
    double speed_rpm_, depth_mm_;             ///< on their way to what is wanted
    double force_ = 0;
    double steady_ = 0;  ///< mean of the deflection
    std::uint64_t random_ = 0x853c49e6748fea9bULL;
};

/// What a loudspeaker is given: one cut after the other, quiet where nothing vibrates, never above full scale.
class CutSound {
public:
    explicit CutSound(double sample_rate_hz = 44100) : rate_hz_(sample_rate_hz) {}

    /// Another part or machine: fades over to it.
    void take(const std::vector<Mode>& modes, const StreamParameters& parameters);
    void moveTo(double speed_rpm, double depth_mm);
    bool hasCut() const { return !streams_.empty(); }

    /// The next samples, within ±1, loudness `volume` of 0 to 1; a change of it glides. Silence without a cut.
    void fill(std::span<float> samples, double volume);

private:
    struct Voice {
        CutStream stream;
        double share = 0;  ///< of the loudness, on its way to 1 or, of all but the last, to 0
    };

    double rate_hz_;
    std::vector<Voice> streams_;
    std::vector<float> part_;  ///< of one voice
    double loud_ = 0;          ///< mean size of what was heard
    double volume_ = 0;        ///< on its way to what is asked
};

}  // namespace lathelier::stability
