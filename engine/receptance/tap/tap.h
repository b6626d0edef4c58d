// Impact test: from the force of a hammer and the motion of a sensor over time to a frequency response.
//
// Each hit gives a block of both signals; their spectra F and X are averaged over the hits:
//   H1 = Σ X F* / Σ F F*   (noise of the sensor averages out; noise of the hammer makes it too low)
//   H2 = Σ X X* / Σ F X*   (the reverse: noise of the sensor makes it too high)
//   γ² = |Σ X F*|² / (Σ F F* · Σ X X*)
// An exponential window exp(-σt) on both signals moves the response from iω to iω + σ, exactly: every mode decays
// faster by σ. Velocity and acceleration become a displacement by division by (iω + σ) and its square.
//
// Source: J. S. Bendat and A. G. Piersol, "Random Data", 4th ed., chapter 6 (estimators, coherence); D. J. Ewins,
// "Modal Testing", 2nd ed., section 3.9 (windows, double hits); D. L. Brown, R. J. Allemang and A. W. Phillips, "Forty
// years of use and abuse of impact testing", 2015.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/frf.h"
#include "engine/core/progress.h"

namespace lathelier::receptance {

enum class TapEstimator { H1, H2 };
enum class TapWindow { None, ForceExponential };

struct TapParameters {
    TapEstimator estimator = TapEstimator::H1;
    TapWindow window = TapWindow::None;
    std::optional<double> force_window_s;      ///< from the trigger; none: the pulse and once more its width
    std::optional<double> exponential_time_s;  ///< time in which the window falls to 1/e; none: a third of the block
    std::optional<double> block_s;             ///< length of a block; none: as long as the hits allow, at most 2 s
    double trigger_percent = 5;                ///< of the largest force of a record
    std::optional<double> pre_trigger_s;       ///< none: 2 % of the block
    double double_hit_percent = 2;             ///< of the peak: a later rise of the force by more is a second pulse
    double force_drop_db = 20;                 ///< fall of the force's spectrum that ends the usable range
    std::vector<Interval> range_hz;            ///< of the lines handed on, one interval; empty: the usable ones
    bool keep_rejected = false;                ///< average rejected hits as well
};

const std::vector<Field<TapParameters>>& fieldsOf(const TapParameters*);

/// Force and motion of one record, in the same samples.
struct TapSignals {
    std::string path;             ///< for notes
    double rate_hz = 1;           ///< samples a second
    double start_s = 0;           ///< time of the first sample
    std::vector<double> force_N;  ///< by sample
    std::vector<double> motion;   ///< mm, mm/s or mm/s² by the quantity
    std::vector<char> at_limit;  ///< by sample: 1 force, 2 motion, 3 both at the end of the converter's range; or empty
};

/// Why a hit is not used.
enum class HitFault { None, DoubleHit, OverloadForce, OverloadResponse, Weak, Incomplete };
const char* key(HitFault fault);  ///< "double_hit"; "" for None
Text words(HitFault fault);

struct TapHit {
    std::size_t record = 0;                ///< index of its record
    std::size_t first = 0;                 ///< first sample of the block
    std::size_t trigger = 0;               ///< sample at which the force passes the level
    std::size_t pulse_end = 0;             ///< sample behind the last pulse
    double time_s = 0;                     ///< of the trigger, as the record counts
    double peak_N = 0;                     ///< with its sign
    std::optional<double> second_percent;  ///< rise of a second pulse, of the peak
    std::optional<double> second_s;        ///< time of its top
    HitFault fault = HitFault::None;
    bool used = true;
};

struct TapResult {
    std::vector<TapHit> hits;  ///< in the order of the records and of time
    Frf response;              ///< receptance over the usable lines with its noise; coherence from two hits on
    FrfQuantity measured = FrfQuantity::Accelerance;  ///< quantity of the sensor per force
    std::vector<double> frequency_hz;                 ///< all lines above 0
    std::vector<double> force_db;                     ///< spectrum of the force, relative to its maximum
    std::vector<double> coherence;                    ///< of all lines; empty with one hit
    std::size_t averages = 0;                         ///< hits used
    std::size_t samples = 0;                          ///< of a block
    double rate_hz = 0;
    double resolution_hz = 0;  ///< distance of the lines
    double usable_from_hz = 0, usable_to_hz = 0;
    double window_decay_1_s = 0;  ///< added to the decay of every mode; 0: no exponential window
    double force_window_s = 0;    ///< longest used, from the trigger; 0: none
    TapParameters parameters;
    Notes notes;
};

/// The response per force. All records have the same rate and quantity. Errors tapNoHit, tapNoHitUsed,
/// tapBlockTooShort, tapNoLines; valueNotUnderstood for more than one range. Throws Cancelled.
TapResult evaluateTaps(const std::vector<TapSignals>& records, FrfQuantity measured, const TapParameters& parameters,
                       const Progress& progress = {});

}  // namespace lathelier::receptance
