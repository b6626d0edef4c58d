// Recommended stable spindle speed near a selected one. Source: Jasiewicz and Miądlicki, "An integrated CNC system for
// chatter suppression in turning", eq. 24, interpreted such that the numbers of this paper and of
// "Remanufacturing System with Chatter Suppression for CNC Turning" are reproduced: f_m = arg min Re G, k = ceil(60
// f_m/N), N_cor = N_Lo1 + P_sh (N_Lo2 - N_Lo1) with N_Lo1 = 60 f_m/k and N_Lo2 = 60 f_m/(k-1): the lobe that holds the
// selected speed. With the exact relation that point lies beyond the peak of the pocket; instead the speed that
// maximises the minimum depth within ±2 % is used.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/frf.h"
#include "engine/core/units.h"
#include "engine/stability/lobes.h"

namespace lathelier::stability {

enum class SpeedRule { Lobe, Nearest };  ///< Lobe: that of the selected speed's lobe; Nearest: the nearest candidate

struct SpeedParameters {
    std::optional<double> diameter_mm;                  ///< D of the turned surface; needed with a cutting speed
    std::optional<double> cutting_speed_m_min;          ///< selected v_c; alternative to `speed_rpm`
    std::optional<double> speed_rpm;                    ///< selected N
    std::vector<Interval> range_m_min;                  ///< at most one: range of cutting speeds of the tool
    std::optional<double> peak_shift;                   ///< P_sh of the published relation. Default 0.7
    SpeedRule rule = SpeedRule::Lobe;                   ///< rule for the recommended candidate
    SpeedRelation relation = SpeedRelation::Published;  ///< Published: eq. 24; Exact: the robust optimum of the pocket
    double direction_factor = 1;                        ///< D: the oriented receptance is D·G
};

const std::vector<Field<SpeedParameters>>& fieldsOf(const SpeedParameters*);

/// A stable speed of one lobe.
struct SpeedCandidate {
    int k = 0;
    double speed_rpm = 0;
    bool in_range = true;  ///< within range_m_min
};

struct SpeedResult {
    SpeedParameters parameters;
    double frequency_hz = 0;  ///< f_m: frequency of the minimum of Re G
    double selected_rpm = 0;  ///< selected speed, or that of the cutting speed
    double recommended_rpm = 0;
    double recommended_cutting_speed_m_min = notANumber;  ///< NaN without a diameter
    int k = 0;                                            ///< lobe of the selected speed
    Interval lobe_rpm;                       ///< its ends: 60 f_m/k and 60 f_m/(k-1), or those of the pocket
    std::vector<SpeedCandidate> candidates;  ///< k ascending
    Notes notes;                             ///< fromAnotherLobe, minimumAtEdge
};

/// Errors: valueNotUnderstood (neither speed, both, no diameter for a cutting speed or a range, more than one range, a
/// range that runs backwards, a peak shift with the exact relation), noStableSpeed with `candidates` and `reason`;
/// those of leastRealPart().
SpeedResult chooseSpeed(const Frf& frf, const SpeedParameters& parameters);

/// N = 1000 v_c / (π D) in 1/min.
double spindleSpeed(double cutting_speed_m_min, double diameter_mm);

}  // namespace lathelier::stability
