// A cut simulated in time: regenerative chatter with loss of contact.
//
// The tool's deflection x (away from the cut) follows its modes; the force F = K_r a h - C (a/v) ẋ acts while the chip
// has a thickness h = h₀ + w - x above zero. w is the wave that earlier revolutions left: after one in which the tool
// was out of the cut, the surface of the revolution before is still there, w = min(x, w + h₀) (multiple regeneration;
// Y. Altintas, "Manufacturing Automation"; time-domain simulation after J. Tlusty). The limit of stability is that of
// 1 + K_r a G (1 - e^{-iωT}) = 0; growth is taken from the same equation without loss of contact (growth.h).
#pragma once

#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/stability/modes.h"

namespace lathelier::stability {

struct SimulationParameters {
    std::optional<double> speed_rpm;                  ///< N of the spindle; needed
    std::optional<double> depth_mm;                   ///< a, depth of cut; needed
    std::optional<double> cutting_coefficient_N_mm2;  ///< K_r; needed
    double feed_mm_rev = 0.1;                         ///< h₀, chip thickness without vibration
    int revolutions = 200;                            ///< that are simulated
    double direction_factor = 1;                      ///< D: the oriented receptance is D·G
    std::optional<double> process_damping_N_mm;       ///< C; needs the diameter. None: no process damping
    std::optional<double> diameter_mm;                ///< of the turned surface
};

const std::vector<Field<SimulationParameters>>& fieldsOf(const SimulationParameters*);

enum class CutVerdict { Stable, Chatter, Undecided };  ///< by the growth and how well it is known

/// Over one revolution, unrolled along the circumference.
struct WavePair {
    std::vector<double> angle_deg;  ///< 0 to 360
    std::vector<double> outer_mm;   ///< what earlier revolutions left, w
    std::vector<double> inner_mm;   ///< path of the tool in this revolution, x
    double turns = 0;               ///< of the dominant vibration between the two waves: its whole turns and phase
};

struct SimulationResult {
    SimulationParameters parameters;         ///< as asked
    double growth_per_revolution = 0;        ///< factor of the amplitude while the tool keeps contact
    double growth_step_difference = 0;       ///< by which half the time step changed it
    CutVerdict cut = CutVerdict::Undecided;  ///< undecided: the growth differs from 1 by no more than it is known
    double frequency_hz = 0;                 ///< of the vibration that grows fastest or decays slowest
    double amplitude_mm = 0;                 ///< half the range of the deflection over the last tenth of revolutions
    double static_deflection_mm = 0;         ///< of the steady cut
    double lost_contact_percent = 0;         ///< of the time, over the last tenth of the revolutions
    double step_s = 0;                       ///< of the waveform
    int steps_per_revolution = 0;            ///< whole
    std::vector<double> deflection_mm;       ///< x of the tool, from the beginning of the cut
    std::vector<double> chip_mm;             ///< h, at the same times
    WavePair waves;                          ///< of the last revolution
    Notes notes;                             ///< none so far

    double seconds() const { return step_s * static_cast<double>(deflection_mm.size()); }
};

/// The time step is a whole part of a revolution, and halved until that changes the growth by less than 1e-3. Errors:
/// valueNotUnderstood (no mode, no speed, depth or coefficient, process damping without a diameter); simulationTooLong.
/// Throws Cancelled.
SimulationResult simulate(const std::vector<Mode>& modes, const SimulationParameters& parameters,
                          const Progress& progress = {});

/// C a/v in N·s/mm of the process damping C (N/mm) on a surface of this diameter. Source of F = C (a/v) ẋ: C. T. Tyler
/// and T. L. Schmitz, "Analytical process damping stability prediction", J. Manuf. Processes 15 (2013) 69.
double dampingOfCut(double process_damping_N_mm, double depth_mm, double diameter_mm, double speed_rpm);

}  // namespace lathelier::stability
