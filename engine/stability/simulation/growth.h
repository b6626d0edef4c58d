// Growth of a vibration per revolution, by simulating the cut while the tool keeps contact.
//
// The linear delay equation x(t) = G·F, F = -K_r a (x(t) - x(t-T)) - C (a/v) ẋ(t) maps the vibration of one revolution
// onto that of the next. After some revolutions few of the eigenvectors of this map are left in the vibration; they are
// found in the snapshots of the next revolutions (P. J. Schmid, J. Fluid Mech. 656 (2010) 5: dynamic mode
// decomposition). The eigenvalue of the largest size is the growth; above 1 the cut chatters.
#pragma once

#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/stability/modes.h"

namespace lathelier::stability {

/// The forces of one cut.
struct CutForces {
    double stiffness_N_mm = 0;    ///< K_r a: by chip thickness
    double damping_N_s_mm = 0;    ///< C a/v: by speed of the deflection (process damping)
    double direction_factor = 1;  ///< D: the oriented receptance is D·G
};

/// How finely and how long is simulated.
struct GrowthEffort {
    int steps = 0;       ///< in a revolution
    int warm_up = 40;    ///< revolutions before the first snapshot
    int snapshots = 12;  ///< revolutions that are looked at, at most 16
};

struct Growth {
    double per_revolution = 0;  ///< factor of the amplitude
    double frequency_hz = 0;    ///< of the vibration that grows fastest or decays slowest
};

/// So many steps that the highest mode's period has at least `per_period`, and a revolution at least twice as many.
double stepsOfRevolution(std::span<const Mode> modes, double revolution_s, double per_period);

/// Of each cut; all of one direction factor. The answer of a cut does not depend on the others. Preconditions: at
/// least one mode, steps ≥ 8. Throws Cancelled.
std::vector<Growth> growthsOf(std::span<const Mode> modes, std::span<const CutForces> cuts, double revolution_s,
                              const GrowthEffort& effort, const Progress& progress = {});

}  // namespace lathelier::stability
