// State of a lesson: operating point, simulated cut, current view. The tasks of a lesson are checked against it
// (lesson.h); the "why?" box shows its numbers; the body of a step may name them in braces: "{growth:3}".
//
//   waves = 60 f/N = k + ε/2π: f frequency of the vibration, N speed, k whole waves of a revolution, ε the phase
//   between the wave being cut and that of the previous revolution.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/fields.h"
#include "engine/core/quantities.h"
#include "engine/stability/lobes.h"
#include "engine/stability/simulation/simulation.h"
#include "engine/training/scenario.h"

namespace lathelier::training {

/// Views of a state of the training.
enum class View { Lobes, Growth, Waveform, Waves, Surface, Frf, Spindle, Spectrum, Comparison, Why };

/// Key and name of every view, in the order of the enumerators.
const std::vector<FieldChoice>& viewChoices();
/// Key and name of both relations: exact, published.
const std::vector<FieldChoice>& relationChoices();

struct LessonState {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  ///< does not meet any check

    std::string scenario;                    ///< key; "own" for the shop's machine
    double speed_rpm = unknown;              ///< of the operating point
    double depth_mm = unknown;               ///< of the operating point
    double growth_per_revolution = unknown;  ///< factor of the amplitude while the tool keeps contact
    stability::CutVerdict verdict = stability::CutVerdict::Undecided;  ///< of the simulation
    double frequency_hz = unknown;                                     ///< of the vibration
    double amplitude_mm = unknown;                                     ///< reached, with loss of contact
    double lost_contact_percent = unknown;
    double waves_per_revolution = unknown;                                ///< 60 f/N
    double k = unknown;                                                   ///< whole waves: number of the lobe
    double phase_deg = unknown;                                           ///< ε, 0 to 360
    double natural_frequency_hz = unknown;                                ///< of the mode nearest to the vibration
    stability::SpeedRelation relation = stability::SpeedRelation::Exact;  ///< of the displayed lobes
    double limit_mm = unknown;                                            ///< at this speed, exact; infinite: none
    double published_limit_mm = unknown;  ///< at this speed by N = 60 f/k; infinite: none
    double robust_limit_mm = unknown;     ///< least exact limit within ±2 % of the speed; infinite: none
    double minimum_depth_mm = unknown;    ///< limit over all speeds
    View view = View::Lobes;              ///< most recent view
    double heard_s = 0;                   ///< sound played since the step began; without a sound device: displayed
    double score = unknown;               ///< points of the last exercise since the step began, 0 to 10
};

/// scenario, speed_rpm, depth_mm, growth, verdict, frequency_hz, amplitude_mm, lost_contact_percent, waves, k,
/// phase_deg, natural_frequency_hz, relation, limit_mm, published_limit_mm, robust_limit_mm, minimum_depth_mm, view,
/// heard_s, score. Words (scenario, verdict, relation, view) are keys.
const std::vector<QuantityOf<LessonState>>& quantitiesOf(const LessonState*);

/// The state of a simulated cut of the scenario; view, heard_s and score are set by the caller. `limits` are those of
/// the scenario.
LessonState stateOf(const Scenario& scenario, const Limits& limits, stability::SpeedRelation relation,
                    const stability::SimulationResult& cut);

/// The same by growth and frequency alone, without the waveform (amplitude_mm and lost_contact_percent unknown).
LessonState stateOf(const Scenario& scenario, const Limits& limits, stability::SpeedRelation relation, double speed_rpm,
                    double depth_mm);

}  // namespace lathelier::training
