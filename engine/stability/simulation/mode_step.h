// A mode of vibration over one time step in which the force runs straight from one value to the next.
//
// q̈ + 2ζω q̇ + ω² q = (ω²/k) F has for such a force a closed solution: the state (q, q̇) goes on by the exponential of
// the 2×2 state matrix, the force by two columns, one for its value at either end. A force that is held over the step
// would lag by half a step and feed the vibration; a straight one lags by nothing and is only too small by
// (ω Δt)²/12.
#pragma once

#include <span>
#include <vector>

#include "engine/stability/modes.h"

namespace lathelier::stability {

/// New deflection = qq·q + qv·q̇ + q0·F₀ + q1·F₁, new speed = vq·q + vv·q̇ + v0·F₀ + v1·F₁.
struct ModeStep {
    double qq = 0, qv = 0, vq = 0, vv = 0;  ///< exponential of the state matrix: 1, s, 1/s, 1
    double q0 = 0, q1 = 0;                  ///< deflection by the force at the beginning and the end, mm/N
    double v0 = 0, v1 = 0;                  ///< speed by the same, mm/(s·N)
};

/// `factor` multiplies the receptance (direction).
ModeStep modeStep(const Mode& mode, double step_s, double factor = 1);

/// The same of all modes, with what one newton at the end of the step does to their sum.
struct ModeSteps {
    std::vector<ModeStep> modes;  ///< in their order
    double q1 = 0;                ///< deflection of all, mm/N
    double v1 = 0;                ///< speed of all, mm/(s·N)
};
ModeSteps modeSteps(std::span<const Mode> modes, double step_s, double factor = 1);

}  // namespace lathelier::stability
