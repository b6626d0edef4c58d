#include "engine/stability/simulation/mode_step.h"

#include <cmath>
#include <numbers>

namespace lathelier::stability {

ModeStep modeStep(const Mode& mode, double step_s, double factor)
{
    const double compliance = factor / mode.stiffness_N_mm;
    if (!mode.hasMass()) {
        ModeStep still;
        still.q1 = compliance;
        still.v1 = compliance / step_s;  // the force runs straight within the step
        still.v0 = -still.v1;
        return still;
    }
    const double omega = 2 * std::numbers::pi * mode.frequency_hz, zeta = mode.damping_ratio;
    const double damped = omega * std::sqrt(std::fmax(0, 1 - zeta * zeta));
    const double decay = std::exp(-zeta * omega * step_s);
    const double angle = damped * step_s;
    const double sine_s = decay * (angle > 1e-8 ? std::sin(angle) / damped : step_s);  // sin(ω_d Δt)/ω_d
    const double cosine = decay * std::cos(angle);
    ModeStep step;
    step.qq = cosine + zeta * omega * sine_s;
    step.qv = sine_s;
    step.vq = -omega * omega * sine_s;
    step.vv = cosine - zeta * omega * sine_s;
    // The particular solution for a linear force F₀ + S t is (F₀ + S (t - 2ζ/ω))/k; the difference of the initial state
    // decays by the matrix exponential.
    const double lag = 2 * zeta / (omega * step_s), rate = 1 / step_s;
    step.q0 = compliance * (lag - step.qq * (1 + lag) + step.qv * rate);
    step.q1 = compliance * (1 - lag + step.qq * lag - step.qv * rate);
    step.v0 = compliance * (-rate - step.vq * (1 + lag) + step.vv * rate);
    step.v1 = compliance * (rate + step.vq * lag - step.vv * rate);
    step.lag_s = mode.lead / omega;
    step.rate_q = -mode.lead * omega;
    step.rate_v = 1 - 2 * zeta * mode.lead;
    step.rate_F = mode.lead * omega * compliance;
    return step;
}

ModeSteps modeSteps(std::span<const Mode> modes, double step_s, double factor)
{
    ModeSteps steps;
    steps.modes.reserve(modes.size());
    for (const Mode& mode : modes) {
        steps.modes.push_back(modeStep(mode, step_s, factor));
        const ModeStep& one = steps.modes.back();
        steps.q1 += one.q1 + one.lag_s * one.v1;
        steps.v1 += one.rate_q * one.q1 + one.rate_v * one.v1 + one.rate_F;
    }
    return steps;
}

}  // namespace lathelier::stability
