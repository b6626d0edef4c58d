#include "engine/training/lesson_state.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/stability/simulation/cut_views.h"
#include "engine/stability/simulation/simulation_report.h"

namespace lathelier::training {
namespace {

constexpr double robustShare = 0.02;      ///< ± share of the speed
constexpr double growthTolerance = 1e-3;  ///< growths closer to 1 are undecided

double limitAt(const stability::LobeResult& lobes, double speed_rpm)
{
    const double limit = stability::pointStabilityAt(lobes, speed_rpm, 0).limit_mm;
    return std::isnan(limit) ? HUGE_VAL : limit;
}

double naturalFrequencyNextTo(const std::vector<stability::Mode>& modes, double frequency_hz)
{
    double nearest = LessonState::unknown;
    for (const stability::Mode& mode : modes)
        if (mode.isResonance() && !(std::abs(mode.frequency_hz - frequency_hz) >= std::abs(nearest - frequency_hz)))
            nearest = mode.frequency_hz;
    return nearest;
}

/// State without the quantities of the simulated cut.
LessonState stateAt(const Scenario& scenario, const Limits& limits, stability::SpeedRelation relation, double speed_rpm,
                    double depth_mm, double frequency_hz)
{
    LessonState state;
    state.scenario = scenario.key;
    state.speed_rpm = speed_rpm;
    state.depth_mm = depth_mm;
    state.relation = relation;
    state.frequency_hz = frequency_hz;
    state.waves_per_revolution = 60 * frequency_hz / speed_rpm;
    const stability::WavePhase phase = stability::phaseOf(frequency_hz, speed_rpm, scenario.feed_mm_rev);
    state.k = phase.whole;
    state.phase_deg = phase.phase_deg;
    state.natural_frequency_hz = naturalFrequencyNextTo(scenario.modes, frequency_hz);
    state.limit_mm = limitAt(limits.exact, speed_rpm);
    state.published_limit_mm = limitAt(limits.published, speed_rpm);
    state.robust_limit_mm = leastAbout(limits.exact.limit, speed_rpm, robustShare);
    state.minimum_depth_mm = limits.exact.minimum_depth_mm.value_or(HUGE_VAL);
    return state;
}

}  // namespace

const std::vector<FieldChoice>& viewChoices()
{
    static const std::vector<FieldChoice> all{{"lobes", LT_TEXT("Engine", "Lobes")},
                                              {"growth", LT_TEXT("Engine", "Growth")},
                                              {"waveform", LT_TEXT("Engine", "Waveform")},
                                              {"waves", LT_TEXT("Engine", "Inner and outer wave")},
                                              {"surface", LT_TEXT("Engine", "Surface")},
                                              {"frf", LT_TEXT("Engine", "Frequency response")},
                                              {"spindle", LT_TEXT("Engine", "Spindle")},
                                              {"spectrum", LT_TEXT("Engine", "Spectrum")},
                                              {"comparison", LT_TEXT("Engine", "Paper against exact")},
                                              {"why", LT_TEXT("Engine", "Why?")}};
    return all;
}

const std::vector<FieldChoice>& relationChoices()
{
    static const std::vector<FieldChoice> all{{"exact", LT_TEXT("Engine", "Exact")},
                                              {"published", LT_TEXT("Engine", "As published")}};
    return all;
}

const std::vector<QuantityOf<LessonState>>& quantitiesOf(const LessonState*)
{
    using S = LessonState;
    static const auto all = describedBy<S>(
        quantity<S>("scenario", &S::scenario, {LT_TEXT("Engine", "Scenario")}),
        quantity<S>("speed_rpm", &S::speed_rpm, {LT_TEXT("Engine", "Spindle speed"), unit::rpm, 0}),
        quantity<S>("depth_mm", &S::depth_mm, {LT_TEXT("Engine", "Depth of cut"), unit::mm, 3}),
        quantity<S>("growth", &S::growth_per_revolution, {LT_TEXT("Engine", "Growth per revolution"), {}, 3}),
        quantity<S>("verdict", [](const S& s) { return stability::key(s.verdict); }, {LT_TEXT("Engine", "Verdict")}),
        quantity<S>("frequency_hz", &S::frequency_hz, {LT_TEXT("Engine", "Frequency of the vibration"), unit::hz, 1}),
        quantity<S>("amplitude_mm", &S::amplitude_mm, {LT_TEXT("Engine", "Amplitude at the end"), unit::mm, 4}),
        quantity<S>("lost_contact_percent", &S::lost_contact_percent,
                    {LT_TEXT("Engine", "Time out of the cut at the end"), unit::percent, 1}),
        quantity<S>("waves", &S::waves_per_revolution, {LT_TEXT("Engine", "Waves in a revolution"), {}, 2}),
        quantity<S>("k", &S::k, {LT_TEXT("Engine", "Lobe k"), {}, 0}),
        quantity<S>("phase_deg", &S::phase_deg, {LT_TEXT("Engine", "Phase ε between the waves"), unit::deg, 0}),
        quantity<S>("natural_frequency_hz", &S::natural_frequency_hz,
                    {LT_TEXT("Engine", "Natural frequency next to it"), unit::hz, 1}),
        quantity<S>("relation",
                    [](const S& s) { return relationChoices().at(static_cast<std::size_t>(s.relation)).key; },
                    {LT_TEXT("Engine", "Speed relation")}),
        quantity<S>("limit_mm", &S::limit_mm, {LT_TEXT("Engine", "Limit at this speed"), unit::mm, 3}),
        quantity<S>("published_limit_mm", &S::published_limit_mm,
                    {LT_TEXT("Engine", "Limit at this speed as published"), unit::mm, 3}),
        quantity<S>("robust_limit_mm", &S::robust_limit_mm,
                    {LT_TEXT("Engine", "Least limit within 2 % of the speed"), unit::mm, 3}),
        quantity<S>("minimum_depth_mm", &S::minimum_depth_mm, {LT_TEXT("Engine", "Limit at every speed"), unit::mm, 3}),
        quantity<S>("view", [](const S& s) { return viewChoices().at(static_cast<std::size_t>(s.view)).key; },
                    {LT_TEXT("Engine", "View")}),
        quantity<S>("heard_s", &S::heard_s, {LT_TEXT("Engine", "Heard"), unit::s, 1}),
        quantity<S>("score", &S::score, {LT_TEXT("Engine", "Points of the exercise"), {}, 1}));
    return all;
}

LessonState stateOf(const Scenario& scenario, const Limits& limits, stability::SpeedRelation relation,
                    const stability::SimulationResult& cut)
{
    LessonState state = stateAt(scenario, limits, relation, cut.parameters.speed_rpm.value_or(LessonState::unknown),
                                cut.parameters.depth_mm.value_or(LessonState::unknown), cut.frequency_hz);
    state.growth_per_revolution = cut.growth_per_revolution;
    state.verdict = cut.cut;
    state.amplitude_mm = cut.amplitude_mm;
    state.lost_contact_percent = cut.lost_contact_percent;
    return state;
}

LessonState stateOf(const Scenario& scenario, const Limits& limits, stability::SpeedRelation relation, double speed_rpm,
                    double depth_mm)
{
    const stability::Growth growth = growthOf(scenario, speed_rpm, depth_mm);
    LessonState state = stateAt(scenario, limits, relation, speed_rpm, depth_mm, growth.frequency_hz);
    state.growth_per_revolution = growth.per_revolution;
    using enum stability::CutVerdict;
    state.verdict = growth.per_revolution > 1 + growthTolerance   ? Chatter
                    : growth.per_revolution < 1 - growthTolerance ? Stable
                                                                  : Undecided;
    return state;
}

}  // namespace lathelier::training
