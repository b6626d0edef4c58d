// Exact integration of a mode over one time step with linearly varying force.
//
// q̈ + 2ζω q̇ + ω² q = (ω²/k) F has a closed solution: the state (q, q̇) is multiplied by the exponential of the 2×2
// state matrix, the force at either end by one column each. A constant force over the step would lag by half a step and
// supply energy to the vibration; a linear one has no phase error and an amplitude too small by (ω Δt)²/12. A complex
// mode (modes.h) moves by q + τ q̇, τ = λ/ω. A compliance without mass follows the force at once.
#pragma once

#include <span>
#include <vector>

#include "engine/stability/modes.h"

namespace lathelier::stability {

/// New deflection = qq·q + qv·q̇ + q0·F₀ + q1·F₁, new speed = vq·q + vv·q̇ + v0·F₀ + v1·F₁.
struct ModeStep {
    double qq = 0, qv = 0, vq = 0, vv = 0;  ///< exponential of the state matrix: 1, s, 1/s, 1
    double q0 = 0, q1 = 0;                  ///< deflection per force at start and end, mm/N
    double v0 = 0, v1 = 0;                  ///< velocity per force at start and end, mm/(s·N)
    double lag_s = 0;                       ///< τ: the mode moves by q + τ·q̇
    double rate_q = 0, rate_v = 1;          ///< and its velocity is rate_q·q + rate_v·q̇ + rate_F·F₁
    double rate_F = 0;                      ///< mm/(s·N)
};

/// `factor` multiplies the receptance (direction).
ModeStep modeStep(const Mode& mode, double step_s, double factor = 1);

/// Steps of all modes, with the response of their sum to a unit force at the end of the step.
struct ModeSteps {
    std::vector<ModeStep> modes;
    double q1 = 0;  ///< motion of all, mm/N
    double v1 = 0;  ///< its velocity, mm/(s·N)
};
ModeSteps modeSteps(std::span<const Mode> modes, double step_s, double factor = 1);

}  // namespace lathelier::stability
