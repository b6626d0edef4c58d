// Growth of a vibration per revolution, by simulation of the cut without loss of contact.
//
// The linear delay equation x(t) = G·F, F = -K_r a (x(t) - x(t-T)) - C (a/v) ẋ(t) maps the vibration of one revolution
// onto that of the next. After some revolutions few eigenvectors of this map dominate the vibration; they are
// identified from snapshots of the next revolutions (P. J. Schmid, J. Fluid Mech. 656 (2010) 5: dynamic mode
// decomposition). The largest eigenvalue magnitude is the growth; above 1 the cut chatters.
#pragma once

#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/stability/modes.h"

namespace lathelier::stability {

/// The forces of one cut.
struct CutForces {
    double stiffness_N_mm = 0;    ///< K_r a: force per chip thickness
    double damping_N_s_mm = 0;    ///< C a/v: force per vibration velocity (process damping)
    double direction_factor = 1;  ///< D: the oriented receptance is D·G
};

/// Numerical effort of a simulation.
struct GrowthEffort {
    int steps = 0;       ///< time steps per revolution
    int warm_up = 40;    ///< revolutions before the first snapshot
    int snapshots = 12;  ///< evaluated revolutions, at most 16
};

struct Growth {
    double per_revolution = 0;  ///< factor of the amplitude
    double frequency_hz = 0;    ///< of the vibration that grows fastest or decays slowest
};

/// Number of steps with at least `per_period` in a period of the highest mode whose peak is more than a hundredth of
/// the largest, and at least twice as many in a revolution.
double stepsOfRevolution(std::span<const Mode> modes, double revolution_s, double per_period);

/// Growth of each cut; all have the same direction factor. Results do not depend on the other cuts. Preconditions: at
/// least one mode, steps ≥ 8. Throws Cancelled.
std::vector<Growth> growthsOf(std::span<const Mode> modes, std::span<const CutForces> cuts, double revolution_s,
                              const GrowthEffort& effort, const Progress& progress = {});

}  // namespace lathelier::stability
