#include "widgets/training/training_outcome.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/receptance/modal/modal_fit.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/stability/simulation/cut_views.h"
#include "engine/stability/simulation/growth_chart.h"
#include "engine/stability/simulation/simulation_report.h"
#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_codes.h"
#include "engine/stability/stability_verification.h"
#include "engine/task/memo.h"

namespace lathelier::training_panel {
namespace {

constexpr int reportColumns = 120;   ///< of the map on paper, and rows
constexpr double shownSpectrum = 3;  ///< of the highest natural frequency
constexpr double shownDepth = 5;     ///< shown depth relative to the least limit, without a scenario
constexpr double startDepth = 0.8;   ///< initial depth relative to the least limit, without a scenario

/// What a drag of the operating point does not change.
struct LimitsMemo : Memo<training::Limits> {};
struct FitMemo : Memo<receptance::ModalFit> {};

/// Modes of the shop's machine; empty: a scenario is shown.
std::vector<stability::Mode> ownModes(TrainingOutcome& outcome, const project::PanelState& state, Stores& stores,
                                      const Progress& progress)
{
    auto response = chatter_common::takeResponse(state, stores, progress.part(0, 0.5, LT_TEXT("Engine", "Reading")));
    if (!response) return outcome.question.modes;
    const Frf frf = chatter_common::recordInput(outcome, std::move(response->taken));
    const auto fit =
        stores.of<FitMemo>()->find(response->basis, progress.part(0.5, 1, LT_TEXT("Engine", "Fitting modes")),
                                   [&](const Progress& fitting) { return receptance::fitModes(frf, {}, fitting); });
    outcome.notes.insert(outcome.notes.end(), fit->notes.begin(), fit->notes.end());
    if (fit->modes.empty()) throw Error(errors::modesNeeded, {});
    std::vector<stability::Mode> modes;
    modes.reserve(fit->modes.size());
    for (const receptance::FittedMode& fitted : fit->modes)
        modes.push_back({fitted.mode.frequency_hz, fitted.mode.damping_ratio, fitted.mode.stiffness_N_mm});
    outcome.notes.push_back(
        {notes::modesFitted,
         {{"count", static_cast<std::int64_t>(modes.size())}, {"error_percent", fit->error_rms_percent}}});
    return modes;
}

void setDepths(training::Scenario& scenario, double least_limit_mm)
{
    scenario.greatest_depth_mm = shownDepth * least_limit_mm;
    scenario.start_depth_mm = startDepth * least_limit_mm;
}

void nameAssumed(TrainingOutcome& outcome)
{
    if (outcome.scenario.key != training::ownScenario) return;
    if (!outcome.question.cutting_coefficient_N_mm2)
        outcome.used.push_back({"cutting_coefficient_N_mm2", LT_TEXT("Engine", "Cutting coefficient K_r"),
                                outcome.scenario.cutting_coefficient_N_mm2, unit::N_mm2});
    if (!outcome.question.feed_mm_rev)
        outcome.used.push_back({"feed_mm_rev", LT_TEXT("Engine", "Feed"), outcome.scenario.feed_mm_rev, unit::mm_rev});
}

}  // namespace

TrainingOutcome trainingOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    TrainingOutcome outcome;
    outcome.question = fromValues<TrainingQuestion>(state.parameters);
    const TrainingQuestion& question = outcome.question;
    outcome.scenario = scenarioOf(question, ownModes(outcome, state, stores, progress.part(0, 0.4)));
    const training::Scenario& scenario = outcome.scenario;
    nameAssumed(outcome);
    std::string basis;
    for (const stability::Mode& mode : scenario.modes) basis += toJson(toValues(mode)).dump();
    for (const double number : {scenario.cutting_coefficient_N_mm2, scenario.speed_rpm.from, scenario.speed_rpm.to})
        basis += Json(number).dump() + ' ';
    outcome.limits = stores.of<LimitsMemo>()->find(basis, progress.part(0.4, 0.7, LT_TEXT("Engine", "Finding lobes")),
                                                   [&](const Progress& p) { return training::limitsOf(scenario, p); });
    if (scenario.key == training::ownScenario || question.cutting_coefficient_N_mm2)
        setDepths(outcome.scenario, outcome.limits->exact.minimum_depth_mm.value_or(1));
    outcome.frf = std::make_shared<const Frf>(stability::frfOf(scenario.modes, scenario.speed_rpm.to));
    outcome.point = {question.speed_rpm.value_or(scenario.start_speed_rpm),
                     question.depth_mm.value_or(scenario.start_depth_mm)};
    outcome.cut = std::make_shared<const stability::SimulationResult>(
        simulate(scenario.modes, training::cutOf(scenario, outcome.point.speed_rpm, outcome.point.depth_mm),
                 progress.part(0.7, 1, LT_TEXT("Engine", "Simulating"))));
    outcome.state = training::stateOf(scenario, *outcome.limits, question.relation, *outcome.cut);
    return outcome;
}

report::Answer answer(const TrainingOutcome& outcome, const Language& language)
{
    const stability::SimulationResult& cut = *outcome.cut;
    const training::LessonState& state = outcome.state;
    report::Answer answer;
    answer.values = {{"speed", fixed(outcome.point.speed_rpm, 0, language)},
                     {"depth_mm", outcome.point.depth_mm},
                     {"frequency", fixed(cut.frequency_hz, 1, language)},
                     {"limit_mm", state.limit_mm},
                     {"k", fixed(state.k, 0, language)},
                     {"phase", fixed(state.phase_deg, 0, language)}};
    answer.used = outcome.used;
    if (outcome.question.hide_chart) {
        answer.quantity = LT_TEXT("Engine", "Does it chatter?");
        answer.verdict_words = LT_TEXT("Engine", "listen");
        answer.sentence = LT_TEXT("Engine", "{speed} 1/min · depth {depth_mm:3} mm");
        return answer;
    }
    answer.quantity = LT_TEXT("Engine", "Growth per revolution");
    answer.value = cut.growth_per_revolution;
    answer.upper_limit = 1;
    answer.decimals = 3;
    switch (cut.cut) {
        case stability::CutVerdict::Stable:
            answer.verdict = Verdict::Pass;
            answer.verdict_words = LT_TEXT("Engine", "✓ stable");
            break;
        case stability::CutVerdict::Chatter:
            answer.verdict = Verdict::Fail;
            answer.verdict_words = LT_TEXT("Engine", "✗ chatter");
            break;
        case stability::CutVerdict::Undecided: answer.verdict = Verdict::Undecided; break;
    }
    answer.sentence =
        std::isfinite(state.limit_mm)
            ? LT_TEXT(
                  "Engine",
                  "{speed} 1/min · depth {depth_mm:3} mm, limit {limit_mm:3} mm · {frequency} Hz · {k} whole waves, "
                  "ε = {phase}°")
            : LT_TEXT("Engine", "{speed} 1/min · depth {depth_mm:3} mm, no lobe limits here · {frequency} Hz");
    return answer;
}

double highestShown(const TrainingOutcome& outcome)
{
    double highest = 0;
    for (const stability::Mode& mode : outcome.scenario.modes) highest = std::max(highest, mode.frequency_hz);
    return shownSpectrum * highest;
}

stability::RasterParameters rasterOf(const TrainingOutcome& outcome)
{
    stability::RasterParameters p;
    p.cutting_coefficient_N_mm2 = outcome.scenario.cutting_coefficient_N_mm2;
    p.speed_rpm = outcome.scenario.speed_rpm;
    p.depth_mm = {0, outcome.scenario.greatest_depth_mm};
    return p;
}

report::Document reportOf(const TrainingOutcome& outcome, const Language& language, const Progress& progress)
{
    stability::RasterParameters asked = rasterOf(outcome);
    asked.columns = asked.rows = reportColumns;
    const stability::RasterResult raster = stabilityRaster(outcome.scenario.modes, asked, progress);
    const stability::SimulationResult& cut = *outcome.cut;
    report::Document document;
    document.title = LT_TEXT("Engine", "Training: a cut and its chatter");
    document.verification = {&stability::stabilityVerification()};
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    report::Section first{LT_TEXT("Engine", "Result"), {answer(outcome, language)}};
    first.blocks.emplace_back(report::Paragraph{outcome.scenario.description, {}});
    first.blocks.emplace_back(growthChart(outcome.lobes(), &raster, outcome.point, language));
    if (!outcome.notes.empty()) first.blocks.emplace_back(outcome.notes);
    document.sections.push_back(std::move(first));
    document.sections.push_back(
        {LT_TEXT("Engine", "The cut"),
         {report::quantityTable(LT_TEXT("Engine", "Simulated cut"), cut,
                                {"verdict_words", "growth_per_revolution", "frequency_hz", "wave_turns", "amplitude_mm",
                                 "lost_contact_percent"}),
          waveformPlot(cut), amplitudePlot(cut), wavesPlot(cut, cut.waves, language),
          surfaceMap(cut, revolutionsOf(cut) - 1), spectrumPlot(cut, highestShown(outcome), language)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Published relation against the exact one"),
         {comparisonChart(outcome.limits->exact, outcome.limits->published, &raster, outcome.point, language)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::parametersTable(outcome.question, language), report::parametersTable(cut.parameters, language)}});
    return document;
}

}  // namespace lathelier::training_panel
