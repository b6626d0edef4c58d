// Modes through a response whose poles are known, as a simulation takes them: complex modes, smooth terms and a
// compliance without mass, by linear least squares on its lines.
//
// A simulation knows no range of lines: what it would find outside them must not chatter where the limits, which are
// those of the lines, do not. There Re G stays above -1/(2 F'), F' the force per deflection of the cut that is
// simulated, for as little of the response within the lines as possible. Lines are weighted by 1/|G|, but none that is
// too small to chatter at that force: 2 F'|G| < 1 is stable (small gain).
#pragma once

#include <optional>
#include <vector>

#include "engine/core/frf.h"
#include "engine/stability/modes.h"
#include "engine/stability/simulation/pole_basis.h"
#include "engine/stability/simulation/simulation.h"

namespace lathelier::stability {

/// `broad`: further strongly damped terms, for what is known to lie outside the lines. `stiffness_N_mm`: K_r a D of the
/// strongest cut that is simulated. Precondition: a receptance of at least four lines.
std::vector<Mode> modesThrough(const Frf& frf, const std::vector<Pole>& poles, const std::vector<Pole>& broad,
                               double stiffness_N_mm);

/// 100 rms|model - G| / rms|G| over the lines above 0 Hz.
double overallError_percent(const std::vector<Mode>& modes, const Frf& frf);

/// Largest error of a model at the frequency of the vibration with which a verdict stands.
inline constexpr double largestModelError_percent = 10;

/// Enters the errors of the model against its response into the result; where the model is too far off or the vibration
/// outside the lines the verdict becomes undecided, with the note modelLeavesMuch or vibrationOutsideLines.
void judgeModel(SimulationResult& result, const std::vector<Mode>& modes, const Frf& frf);

}  // namespace lathelier::stability
