// Scenarios of the training: a lathe whose modes are known, as data.
//
// They cover the cases taught in a class: a short stiff part; a slender one with one weak mode (223 Hz, ζ 0.03, 1e7
// N/m, K_r 2e9 N/m²: the example of Jasiewicz and Miądlicki, "An integrated CNC system for chatter suppression in
// turning"); the same held by a tailstock; the short part in a spindle whose bearing is worn. Their lobes are separated
// between 1000 and 4000 1/min, their limits are tenths of a millimetre to a few, and their chatter is audible (150 to
// 900 Hz). A school's own machine is a Scenario as well: its modes come from a modal fit or from the shaft's model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/text.h"
#include "engine/core/value.h"
#include "engine/stability/lobes.h"
#include "engine/stability/modes.h"
#include "engine/stability/simulation/growth.h"
#include "engine/stability/simulation/simulation.h"

namespace lathelier::training {

struct Scenario {
    std::string key;                       ///< stable identifier used in lessons: "slender"
    Text name;                             ///< short, for a list
    Text description;                      ///< one sentence
    std::vector<stability::Mode> modes;    ///< of the point that is cut, in the direction of the chip thickness
    double cutting_coefficient_N_mm2 = 0;  ///< K_r
    double diameter_mm = 0;                ///< of the turned surface
    double feed_mm_rev = 0;                ///< h₀
    Interval speed_rpm;
    double greatest_depth_mm = 0;
    double start_speed_rpm = 0;  ///< initial operating point
    double start_depth_mm = 0;   ///< initial operating point
};

/// Key of a scenario that is none of scenarios(): the shop's own machine.
inline constexpr const char* ownScenario = "own";

/// In teaching order: rigid, slender, tailstock, worn_bearing.
const std::vector<Scenario>& scenarios();

/// The scenario of this key, or nullptr.
const Scenario* findScenario(std::string_view key);

/// Its lobes over the speeds shown, extended at both ends for evaluation around a speed.
stability::LobeParameters lobesOf(const Scenario& scenario, stability::SpeedRelation relation);

/// One cut, simulated for at least `seconds`. Precondition: speed_rpm > 0.
stability::SimulationParameters cutOf(const Scenario& scenario, double speed_rpm, double depth_mm, double seconds = 1);

/// Growth and frequency of one cut, without its waveform (about 1 ms).
stability::Growth growthOf(const Scenario& scenario, double speed_rpm, double depth_mm);

/// The limiting depth at one speed; infinite where no lobe limits.
double limit_mm(const Scenario& scenario, double speed_rpm, stability::SpeedRelation relation);

/// The least limit within ±share of a speed; infinite where no lobe limits.
double leastAbout(const stability::LobeLimit& limit, double speed_rpm, double share);

/// Both limits over the speeds shown, computed once for a scenario (about 10 ms).
struct Limits {
    stability::LobeResult exact;      ///< with the phase of the regeneration
    stability::LobeResult published;  ///< N = 60 f/k of the papers
};
Limits limitsOf(const Scenario& scenario, const Progress& progress = {});

}  // namespace lathelier::training
