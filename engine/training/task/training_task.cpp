#include "engine/training/task/training_task.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_input.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/stability/simulation/cut_views.h"
#include "engine/stability/simulation/growth_chart.h"
#include "engine/stability/simulation/response_modes.h"
#include "engine/stability/simulation/simulation_files.h"
#include "engine/stability/simulation/simulation_report.h"
#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_verification.h"
#include "engine/stability/task/point_modes.h"
#include "engine/stability/task/point_response.h"
#include "engine/task/memo.h"

namespace lathelier::training {
namespace {

constexpr int reportColumns = 120;   ///< of the map on paper, and rows
constexpr double shownSpectrum = 3;  ///< of the highest natural frequency
constexpr double shownDepth = 5;     ///< shown depth relative to the least limit, without a scenario
constexpr double startDepth = 0.8;   ///< initial depth relative to the least limit, without a scenario

/// What a drag of the operating point does not change.
struct LimitsMemo : Memo<Limits> {};

/// The response of the shop's machine; none: a scenario or stated modes are shown.
std::optional<stability::PointResponse> ownResponse(const project::PanelState& state, Stores& stores,
                                                    task::Sources& sources, const Progress& progress)
{
    if (!task::sourceOf(state, responseRole)) return {};
    return stability::takeResponse(state, {}, stability::usualHighestSpeed_rpm, std::nullopt, stores, sources,
                                   progress);
}

/// Its modes, for the depths that are shown. `found`: notes of the fit.
std::vector<stability::Mode> modesOf(const stability::PointResponse& response, Stores& stores, Notes& found,
                                     const Progress& progress)
{
    const double least_mm_N = -stability::leastRealPart(*response.frf).real_mm_N;
    return stability::modesOfPoint(response, least_mm_N > 0 ? shownDepth / (2 * least_mm_N) : 0, stores, found,
                                   progress);
}

void setDepths(Scenario& scenario, double least_limit_mm)
{
    scenario.greatest_depth_mm = shownDepth * least_limit_mm;
    scenario.start_depth_mm = startDepth * least_limit_mm;
}

void nameAssumed(TrainingOutcome& outcome)
{
    if (outcome.scenario.key != ownScenario) return;
    if (!outcome.question.cutting_coefficient_N_mm2)
        outcome.used.push_back({"cutting_coefficient_N_mm2", LT_TEXT("Engine", "Cutting coefficient K_r"),
                                outcome.scenario.cutting_coefficient_N_mm2, unit::N_mm2});
    if (!outcome.question.feed_mm_rev)
        outcome.used.push_back({"feed_mm_rev", LT_TEXT("Engine", "Feed"), outcome.scenario.feed_mm_rev, unit::mm_rev});
}

}  // namespace

TrainingOutcome answerTraining(const project::PanelState& state, Stores& stores, task::Sources& sources,
                               const Progress& progress)
{
    TrainingOutcome outcome;
    Notes found;
    outcome.question = fromValues<TrainingQuestion>(state.parameters);
    const TrainingQuestion& question = outcome.question;
    const std::optional<stability::PointResponse> response =
        ownResponse(state, stores, sources, progress.part(0, 0.2, LT_TEXT("Engine", "Reading")));
    outcome.scenario = scenarioOf(
        question, response
                      ? modesOf(*response, stores, found, progress.part(0.2, 0.4, LT_TEXT("Engine", "Fitting modes")))
                      : question.modes);
    const Scenario& scenario = outcome.scenario;
    nameAssumed(outcome);
    std::string basis = keyOf(scenario.modes);
    for (const double number : {scenario.cutting_coefficient_N_mm2, scenario.speed_rpm.from, scenario.speed_rpm.to})
        basis += Json(number).dump() + ' ';
    outcome.limits = stores.of<LimitsMemo>()->find(basis, progress.part(0.4, 0.7, LT_TEXT("Engine", "Finding lobes")),
                                                   [&](const Progress& p) { return limitsOf(scenario, p); });
    if (scenario.key == ownScenario || question.cutting_coefficient_N_mm2)
        setDepths(outcome.scenario, outcome.limits->exact.minimum_depth_mm.value_or(1));
    outcome.frf = std::make_shared<const Frf>(stability::frfOf(scenario.modes, scenario.speed_rpm.to));
    outcome.point = {question.speed_rpm.value_or(scenario.start_speed_rpm),
                     question.depth_mm.value_or(scenario.start_depth_mm)};
    stability::SimulationResult cut =
        simulate(scenario.modes, cutOf(scenario, outcome.point.speed_rpm, outcome.point.depth_mm),
                 progress.part(0.7, 1, LT_TEXT("Engine", "Simulating")));
    if (response) judgeModel(cut, scenario.modes, *response->frf);
    found.insert(found.end(), cut.notes.begin(), cut.notes.end());
    outcome.cut = std::make_shared<const stability::SimulationResult>(std::move(cut));
    outcome.state = stateOf(scenario, *outcome.limits, question.relation, *outcome.cut);
    outcome.record(state, sources, found);
    return outcome;
}

report::Answer answer(const TrainingOutcome& outcome, const Language& language)
{
    const stability::SimulationResult& cut = *outcome.cut;
    const LessonState& state = outcome.state;
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
    answer.quantity = LT_TEXT("Engine", "Depth of cut");
    answer.value = outcome.point.depth_mm;
    answer.unit = unit::mm;
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
    // Near the limit the simulation may say otherwise than the lobes: then no ruler contradicts it.
    const bool is_limited = std::isfinite(state.limit_mm);
    const bool is_too_deep = outcome.point.depth_mm > state.limit_mm;
    if (is_limited && answer.verdict == (is_too_deep ? Verdict::Fail : Verdict::Pass))
        answer.upper_limit = std::round(1000 * state.limit_mm) / 1000;  // as the value
    const double growth_percent = 100 * (cut.growth_per_revolution - 1);
    const double room_mm = std::abs(state.limit_mm - outcome.point.depth_mm);
    answer.values.insert(answer.values.end(),
                         {{"growth", fixed(std::abs(growth_percent), 0, language)}, {"room_mm", room_mm}});
    const Text grows = is_limited && is_too_deep
                           ? LT_TEXT("Engine", "Grows {growth} % with each turn · {room_mm:2} mm too deep")
                           : LT_TEXT("Engine", "Grows {growth} % with each turn");
    const Text dies = is_limited && !is_too_deep
                          ? LT_TEXT("Engine", "Dies away by {growth} % with each turn · {room_mm:2} mm to the limit")
                          : LT_TEXT("Engine", "Dies away by {growth} % with each turn");
    answer.sentence = growth_percent > 0 ? grows : dies;
    answer.findings.push_back({is_limited
                                   ? LT_TEXT("Engine", "{speed} 1/min · {frequency} Hz · {k} whole waves, ε = {phase}°")
                                   : LT_TEXT("Engine", "{speed} 1/min · {frequency} Hz · no lobe limits here"),
                               answer.values,
                               {},
                               {}});
    return answer;
}

double highestShown(const TrainingOutcome& outcome)
{
    return shownSpectrum * stability::highestFrequency(outcome.scenario.modes);
}

stability::RasterParameters rasterOf(const TrainingOutcome& outcome)
{
    stability::RasterParameters p;
    p.cutting_coefficient_N_mm2 = outcome.scenario.cutting_coefficient_N_mm2;
    p.speed_rpm = outcome.scenario.speed_rpm;
    p.depth_mm = {0, outcome.scenario.greatest_depth_mm};
    return p;
}

namespace {

/// Every view on paper, with the map of the growth.
report::Document reportOf(const TrainingOutcome& outcome, const Language& language)
{
    stability::RasterParameters asked = rasterOf(outcome);
    asked.columns = asked.rows = reportColumns;
    const stability::RasterResult raster = stabilityRaster(outcome.scenario.modes, asked);
    const stability::SimulationResult& cut = *outcome.cut;
    report::Document document;
    document.title = LT_TEXT("Engine", "Training: a cut and its chatter");
    document.verification = {&stability::stabilityVerification()};
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

}  // namespace

task::Outcome outcomeOf(const std::shared_ptr<const TrainingOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    if (!outcome->question.hide_chart) all.verdict = answer(*outcome).verdict;
    all.json = [outcome] { return nestedJson(describedValues(*outcome->cut)); };
    all.answer = [outcome](const Language& language) { return answer(*outcome, language); };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    all.writers[soundExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, stability::soundOf(*outcome->cut).bytes);
    };
    all.writers[waveformExport] = [outcome](const std::string& path, const Language&, const Progress& progress) {
        io::writeFile(path, [&](const io::Append& append) {
            stability::writeWaveform(*outcome->cut, [&](std::string_view step) {
                progress.check();
                append(step);
            });
        });
    };
    return settled(trainingTask(), std::move(all), outcome->understanding);
}

const task::Task& trainingTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "training";
        made.title = LT_TEXT("Engine", "Training");
        made.summary = "A cut of a scenario with its limits, simulated.";
        made.question = "training";
        made.inputs = {task::optionalInput<io::FrfInput>(
            responseRole, "", LT_TEXT("Engine", "Frequency response"),
            LT_TEXT("Engine", "Of a machine of your own, in place of the scenario: UFF, CSV or MAT."))};
        task::askFor<TrainingQuestion>(made);
        made.exports = {{soundExport, "Write the vibration as sound, FILE.wav (16 bit, mono, 44.1 kHz).",
                         LT_TEXT("Engine", "Sound of the cut (WAV)…"), LT_TEXT("Engine", "Sound (*.wav)"), "wav"},
                        {waveformExport, "Write the waveform as FILE.csv.", LT_TEXT("Engine", "Waveform (CSV)…"),
                         LT_TEXT("Engine", "Table (*.csv)"), "csv"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const TrainingOutcome>(answerTraining(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::training
