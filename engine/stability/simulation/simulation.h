// A cut simulated in time: regenerative chatter with loss of contact.
//
// The tool's deflection x (away from the cut) follows its modes; the force F = K_r a h - C (a/v) ẋ acts while the chip
// thickness h = h₀ + w - x is positive. w is the wave that earlier revolutions left: where the tool left the cut, the
// surface of the revolution before remains, w = min(x, w + h₀) (multiple regeneration; Y. Altintas, "Manufacturing
// Automation"; time-domain simulation after J. Tlusty). The limit of stability is that of 1 + K_r a G (1 - e^{-iωT}) =
// 0; growth is that of the same equation without loss of contact (growth.h).
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
    int revolutions = 200;
    double direction_factor = 1;                 ///< D: the oriented receptance is D·G
    std::optional<double> process_damping_N_mm;  ///< C; needs the diameter. None: no process damping
    std::optional<double> diameter_mm;           ///< of the turned surface
};

const std::vector<Field<SimulationParameters>>& fieldsOf(const SimulationParameters*);

enum class CutVerdict { Stable, Chatter, Undecided };  ///< from the growth and its numerical error

/// Waves of one revolution, unrolled along the circumference.
struct WavePair {
    std::vector<double> angle_deg;  ///< 0 to 360
    std::vector<double> outer_mm;   ///< surface w left by earlier revolutions
    std::vector<double> inner_mm;   ///< path of the tool in this revolution, x
    double turns = 0;               ///< waves per revolution of the dominant vibration, whole and fraction
};

struct SimulationResult {
    SimulationParameters parameters;
    double growth_per_revolution = 0;        ///< factor of the amplitude while the tool keeps contact
    double growth_step_difference = 0;       ///< change of the growth when the time step is halved
    CutVerdict cut = CutVerdict::Undecided;  ///< undecided: the growth differs from 1 by less than its error
    double frequency_hz = 0;                 ///< of the vibration that grows fastest or decays slowest
    double amplitude_mm = 0;                 ///< half the range of the deflection over the last tenth of revolutions
    double static_deflection_mm = 0;         ///< of the steady cut
    double lost_contact_percent = 0;         ///< of the time, over the last tenth of the revolutions
    double step_s = 0;                       ///< of the waveform
    int steps_per_revolution = 0;
    std::vector<double> deflection_mm;  ///< x of the tool, from the beginning of the cut
    std::vector<double> chip_mm;        ///< h, at the same times
    WavePair waves;                     ///< of the last revolution
    /// Of the modes against the response that they are of, at the frequency of the vibration; none: modes were stated,
    /// or the vibration lies outside the lines of the response.
    std::optional<double> model_error_percent;
    std::optional<double> model_error_overall_percent;  ///< the same over all lines, rms by rms
    Notes notes;                                        ///< those of judgeModel() (response_modes.h)

    double seconds() const { return step_s * static_cast<double>(deflection_mm.size()); }
};

/// The time step divides a revolution, and is halved until the growth changes by less than 1e-3. Errors:
/// valueNotUnderstood (no mode, no speed, depth or coefficient, process damping without a diameter); simulationTooLong.
/// Throws Cancelled.
SimulationResult simulate(const std::vector<Mode>& modes, const SimulationParameters& parameters,
                          const Progress& progress = {});

/// C a/v in N·s/mm of the process damping C (N/mm) on a surface of this diameter. Source of F = C (a/v) ẋ: C. T. Tyler
/// and T. L. Schmitz, "Analytical process damping stability prediction", J. Manuf. Processes 15 (2013) 69.
double dampingOfCut(double process_damping_N_mm, double depth_mm, double diameter_mm, double speed_rpm);

}  // namespace lathelier::stability
