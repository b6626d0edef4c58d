#include "engine/stability/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/stability/refusal.h"
#include "engine/stability/simulation/growth.h"
#include "engine/stability/simulation/mode_step.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr double firstStepsPerPeriod = 48;  ///< initial steps per period of the highest mode
constexpr double growthTolerance = 1e-3;    ///< accepted change of the growth when the step is halved
constexpr int mostHalvings = 5;
constexpr double mostWaveformSteps = 5e7;  ///< limit for the waveform, and for a revolution of the growth
constexpr double lastShare = 0.1;          ///< share of revolutions evaluated as final state
constexpr std::size_t stepsBetweenReports = 1 << 15;

CutForces forcesOf(const SimulationParameters& p)
{
    if (!p.speed_rpm) refuse("speed_rpm", Value(), LT_TEXT("Engine", "the speed of the spindle"));
    if (!p.depth_mm) refuse("depth_mm", Value(), LT_TEXT("Engine", "the depth of cut"));
    if (!p.cutting_coefficient_N_mm2)
        refuse("cutting_coefficient_N_mm2", Value(), LT_TEXT("Engine", "the cutting coefficient"));
    CutForces cut{*p.cutting_coefficient_N_mm2 * *p.depth_mm, 0, p.direction_factor};
    if (!p.process_damping_N_mm) return cut;
    if (!p.diameter_mm) refuse("diameter_mm", Value(), LT_TEXT("Engine", "the diameter for the process damping"));
    cut.damping_N_s_mm = dampingOfCut(*p.process_damping_N_mm, *p.depth_mm, *p.diameter_mm, *p.speed_rpm);
    return cut;
}

/// Growth with a converged step; `steps` returns the steps per revolution.
Growth fineGrowthOf(const std::vector<Mode>& modes, const CutForces& cut, double revolution_s, int& steps,
                    double& difference, const Progress& progress)
{
    const auto with = [&](int count) {
        GrowthEffort effort;
        effort.steps = count;
        return growthsOf(modes, {&cut, 1}, revolution_s, effort, progress).front();
    };
    Growth coarse = with(steps);
    for (int halving = 0;; ++halving) {
        const Growth fine = with(2 * steps);
        steps *= 2;
        difference = std::abs(fine.per_revolution - coarse.per_revolution);
        if (difference < growthTolerance || halving + 1 == mostHalvings || 2.0 * steps > mostWaveformSteps) return fine;
        coarse = fine;
    }
}

/// Simulates the whole cut with loss of contact into `result`.
void simulateContactLoss(const std::vector<Mode>& modes, const CutForces& cut, SimulationResult& result,
                         const Progress& progress)
{
    const auto steps = static_cast<std::size_t>(result.steps_per_revolution);
    const std::size_t all = steps * static_cast<std::size_t>(result.parameters.revolutions);
    const double feed = result.parameters.feed_mm_rev;
    const ModeSteps constants = modeSteps(modes, result.step_s, cut.direction_factor);
    const double share = 1 / (1 + cut.stiffness_N_mm * constants.q1 + cut.damping_N_s_mm * constants.v1);
    std::vector<double> deflection(modes.size(), 0.0), speed(modes.size(), 0.0);
    std::vector<double> left(steps, 0.0);  // surface w of the previous revolution
    std::vector<double>& outer = result.waves.outer_mm;
    result.deflection_mm.resize(all);
    result.chip_mm.resize(all);
    double force = 0;
    for (std::size_t i = 0, place = 0; i < all; ++i, place = place + 1 == steps ? 0 : place + 1) {
        if (i % stepsBetweenReports == 0) progress.report(static_cast<double>(i) / static_cast<double>(all));
        if (i + steps == all) outer = left;
        double x = 0, v = 0;
        for (std::size_t m = 0; m < modes.size(); ++m) {
            const ModeStep& c = constants.modes[m];
            const double q = deflection[m], u = speed[m];
            deflection[m] = c.qq * q + c.qv * u + c.q0 * force;
            speed[m] = c.vq * q + c.vv * u + c.v0 * force;
            x += deflection[m] + c.lag_s * speed[m];
            v += c.rate_q * deflection[m] + c.rate_v * speed[m];
        }
        const double wave = left[place];
        force = (cut.stiffness_N_mm * (feed + wave - x) - cut.damping_N_s_mm * v) * share;
        double chip = feed + wave - (x + constants.q1 * force);
        if (!(chip > 0)) force = chip = 0;
        for (std::size_t m = 0; m < modes.size(); ++m) {
            deflection[m] += constants.modes[m].q1 * force;
            speed[m] += constants.modes[m].v1 * force;
        }
        x += constants.q1 * force;
        left[place] = chip > 0 ? x : wave + feed;
        result.deflection_mm[i] = x;
        result.chip_mm[i] = chip;
    }
    const auto last = result.deflection_mm.end();
    result.waves.inner_mm.assign(last - static_cast<std::ptrdiff_t>(steps), last);
    result.waves.angle_deg.reserve(steps);
    for (std::size_t i = 0; i < steps; ++i)
        result.waves.angle_deg.push_back(360.0 * static_cast<double>(i) / static_cast<double>(steps));
}

void evaluateLastRevolutions(SimulationResult& result)
{
    const int revolutions = std::max(1, static_cast<int>(std::lround(lastShare * result.parameters.revolutions)));
    const auto count = static_cast<std::ptrdiff_t>(revolutions) * result.steps_per_revolution;
    const auto [least, largest] = std::minmax_element(result.deflection_mm.end() - count, result.deflection_mm.end());
    result.amplitude_mm = (*largest - *least) / 2;
    const auto lost = std::count(result.chip_mm.end() - count, result.chip_mm.end(), 0.0);
    result.lost_contact_percent = 100.0 * static_cast<double>(lost) / static_cast<double>(count);
}

}  // namespace

const std::vector<Field<SimulationParameters>>& fieldsOf(const SimulationParameters*)
{
    using P = SimulationParameters;
    static const std::vector<Field<P>> all{
        field("speed_rpm", &P::speed_rpm, Range{1e-3, 1e6},
              Label{LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "Of the cut that is simulated."), unit::rpm}),
        field("depth_mm", &P::depth_mm, Range{1e-9, 1e4},
              Label{LT_TEXT("Engine", "Depth of cut"), LT_TEXT("Engine", "Of the cut that is simulated."), unit::mm}),
        field("cutting_coefficient_N_mm2", &P::cutting_coefficient_N_mm2, Range{1e-3, 1e6},
              Label{LT_TEXT("Engine", "Cutting coefficient K_r"),
                    LT_TEXT("Engine", "Force along the chip thickness over its area."), unit::N_mm2}),
        field("feed_mm_rev", &P::feed_mm_rev, Range{1e-6, 100},
              Label{LT_TEXT("Engine", "Feed"),
                    LT_TEXT("Engine", "Chip thickness without vibration; says when the tool leaves the cut."),
                    unit::mm_rev}),
        field("revolutions", &P::revolutions, Range{1, 100000},
              Label{LT_TEXT("Engine", "Revolutions"), LT_TEXT("Engine", "That are simulated.")}),
        field("direction_factor", &P::direction_factor, Range{-10, 10},
              Label{LT_TEXT("Engine", "Direction factor"),
                    LT_TEXT("Engine", "By which the receptance is multiplied."),
                    {},
                    true}),
        field("process_damping_N_mm", &P::process_damping_N_mm, Range{0, 1e9},
              Label{LT_TEXT("Engine", "Process damping C"),
                    LT_TEXT("Engine", "Of the force C (a/v) ẋ, v the cutting speed; needs the diameter."), unit::N_mm,
                    true}),
        field("diameter_mm", &P::diameter_mm, Range{1e-3, 1e5},
              Label{LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "Of the turned surface; for the process damping."),
                    unit::mm, true})};
    return all;
}

double dampingOfCut(double process_damping_N_mm, double depth_mm, double diameter_mm, double speed_rpm)
{
    return process_damping_N_mm * depth_mm / (std::numbers::pi * diameter_mm * speed_rpm / 60);
}

SimulationResult simulate(const std::vector<Mode>& modes, const SimulationParameters& parameters,
                          const Progress& progress)
{
    if (modes.empty()) refuse("mode", Value(), LT_TEXT("Engine", "at least one mode"));
    SimulationResult result;
    result.parameters = parameters;
    const CutForces cut = forcesOf(parameters);
    const double revolution_s = 60 / *parameters.speed_rpm;
    const double first = stepsOfRevolution(modes, revolution_s, firstStepsPerPeriod);
    const double total = 2 * first * parameters.revolutions;
    if (total > mostWaveformSteps)
        throw Error(errors::simulationTooLong, {{"steps", total}, {"most", mostWaveformSteps}});
    int steps = static_cast<int>(first);
    const Growth growth =
        fineGrowthOf(modes, cut, revolution_s, steps, result.growth_step_difference, progress.part(0, 0.5));
    result.growth_per_revolution = growth.per_revolution;
    result.frequency_hz = growth.frequency_hz;
    const double known = growthTolerance + result.growth_step_difference;
    result.cut = growth.per_revolution > 1 + known   ? CutVerdict::Chatter
                 : growth.per_revolution < 1 - known ? CutVerdict::Stable
                                                     : CutVerdict::Undecided;
    while (static_cast<double>(steps) * parameters.revolutions > mostWaveformSteps)
        steps /= 2;  // the first step always satisfies the limit
    result.steps_per_revolution = steps;
    result.step_s = revolution_s / steps;
    result.waves.turns = result.frequency_hz * revolution_s;
    for (const Mode& mode : modes)
        result.static_deflection_mm +=
            cut.stiffness_N_mm * parameters.feed_mm_rev * cut.direction_factor / mode.stiffness_N_mm;
    simulateContactLoss(modes, cut, result, progress.part(0.5, 1));
    evaluateLastRevolutions(result);
    progress.report(1);
    return result;
}

}  // namespace lathelier::stability
