// Stability lobes: the limiting depth of cut over the spindle speed, lobe by lobe, and their lower envelope.
// Source: Jasiewicz and Miądlicki, "An integrated CNC system for chatter suppression in turning", eq. 21-24, with the
// phase of the regeneration kept: N = 60 f / (k + ε/2π). The papers' N = 60 f/k sets ε to zero and is offered to
// reproduce them. Terms: J. Tlusty, "Manufacturing Processes and Equipment"; Y. Altintas, "Manufacturing Automation".
#pragma once

#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/frf.h"
#include "engine/core/progress.h"
#include "engine/core/units.h"
#include "engine/core/unusual.h"
#include "engine/receptance/modal/uncertain_model.h"
#include "engine/stability/boundary.h"

namespace lathelier::stability {

enum class SpeedRelation { Exact, Published };  ///< Published: N = 60 f/k, the papers' eq. 23

struct LobeParameters {
    std::optional<double> cutting_coefficient_N_mm2;  ///< K_r; none: depths are multiples of the least one
    SpeedRelation relation = SpeedRelation::Exact;    ///< relation of speed and chatter frequency
    std::vector<Interval> speed_rpm;                  ///< at most one range; empty: range of the first lobes
    int points = 2000;                                ///< of the envelope, evenly over the speeds
    double direction_factor = 1;                      ///< D: the oriented receptance is D·G
    std::optional<double> process_damping_N_mm;       ///< C of a force C (a/v) ẋ; none: no process damping
    std::optional<double> diameter_mm;                ///< of the turned surface; for the process damping
    double uncertainty_frequency_percent = 0;         ///< standard uncertainty of the natural frequencies
    double uncertainty_damping_percent = 0;           ///< standard uncertainty of the damping ratios; of modes only
    double uncertainty_compliance_percent = 0;   ///< standard uncertainty of the receptance's size, or of each mode
    double uncertainty_coefficient_percent = 0;  ///< standard uncertainty of the cutting coefficient
};

const std::vector<Field<LobeParameters>>& fieldsOf(const LobeParameters*);

/// Of steels, cast iron, light metals and plastics.
inline const UsualRange usualCoefficient{"cutting_coefficient_N_mm2", {50, 20000}};

/// One lobe within the range of speeds, by ascending chatter frequency. NaN in all three lists separates stretches.
struct Lobe {
    int k = 0;  ///< whole waves between two revolutions
    std::vector<double> speed_rpm;
    std::vector<double> depth_mm;      ///< limiting depth; without K_r a multiple of the least one
    std::vector<double> frequency_hz;  ///< of the chatter
};

/// The lower envelope of all lobes at evenly spaced speeds.
struct LobeLimit {
    std::vector<double> speed_rpm;
    std::vector<double> depth_mm;      ///< NaN where no lobe limits; without K_r a multiple of the least one
    std::vector<double> frequency_hz;  ///< of the chatter at the limit; NaN where no lobe limits
    std::vector<int> k;                ///< of the lobe that limits; -1 where none does
};

/// 95 % band of the limit under the stated uncertainties.
struct LobeBand {
    std::vector<double> low_mm;     ///< 2.5 % quantile at each speed of the limit; NaN where no lobe limits
    std::vector<double> high_mm;    ///< 97.5 % quantile
    std::vector<double> drawn_rpm;  ///< evenly spaced speeds of `drawn`
    std::vector<float> drawn;       ///< limits of the 1000 machines, one after another; infinite where no lobe limits
};

struct LobeResult {
    LobeParameters parameters;
    Interval speed_rpm;  ///< shown range
    /// Limit over all speeds, with process damping over the shown speeds; 1 without K_r; none: no chatter.
    std::optional<double> minimum_depth_mm;
    std::optional<double> frequency_of_minimum_hz;  ///< of the chatter there
    LobeLimit limit;                                ///< lower envelope
    std::vector<Lobe> lobes;                        ///< that reach the range, at most the 200 strongest; k ascending
    std::size_t lobes_in_range = 0;                 ///< with those that are not listed
    std::optional<LobeBand> band;                   ///< with uncertainties
    /// Standard deviation by the noise of the line that limits, in percent of the least depth; none: not known.
    std::optional<double> minimum_noise_percent;
    Notes notes;  ///< noLimit, coefficientUnknown, publishedRelation, minimumAtEdge, minimumInNoise,
                  ///< minimumNotResolved, lobesLeftOut

    /// Are depths multiples of the least one?
    bool isRelative() const { return !parameters.cutting_coefficient_N_mm2; }
};

/// The lobes of the receptance `frf` (mm/N) of the point that is cut. `modes`: of which it consists; with process
/// damping it errs as a whole all the same. Errors: notAReceptance, tooFewLines; valueNotUnderstood for more than one
/// range of speeds, for process damping without coefficient, diameter or the exact relation, and for an uncertainty of
/// the damping without modes. Throws Cancelled.
LobeResult findLobes(const Frf& frf, const LobeParameters& parameters = {}, const Progress& progress = {},
                     const receptance::UncertainModel& modes = {});

/// LobeResult::limit alone, whatever is uncertain. Errors as findLobes(). Throws Cancelled.
LobeLimit limitOf(const Frf& frf, const LobeParameters& parameters, const Progress& progress = {});

/// The limit at evenly spaced speeds from `from_rpm` to `to_rpm`, in 1/compliance (N/mm): divided by K_r it is a depth.
LobeLimit envelope(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, int points);

/// Stability of a point of the chart.
struct PointStability {
    double limit_mm = notANumber;      ///< limiting depth there; NaN: none
    double frequency_hz = notANumber;  ///< chatter frequency at that limit
    int k = -1;                        ///< limiting lobe; -1: none
    bool stable = true;                ///< depth below the limit
    double probability_stable = 1;     ///< under the stated uncertainties; 0 or 1 without any
};
PointStability pointStabilityAt(const LobeResult& result, double speed_rpm, double depth_mm);

}  // namespace lathelier::stability
