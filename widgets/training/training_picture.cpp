#include "widgets/training/training_picture.h"

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
#include "widgets/core/task/memo.h"

namespace lathelier::training_panel {
namespace {

constexpr int reportColumns = 120;   ///< of the map on paper, and rows
constexpr double shownSpectrum = 3;  ///< of the highest natural frequency
constexpr double shownDepth = 5;     ///< of the least limit, where no scenario says it
constexpr double startDepth = 0.8;   ///< of the least limit, likewise

/// What a drag of the operating point does not change.
struct LimitsMemo : Memo<training::Limits> {};
struct FitMemo : Memo<receptance::ModalFit> {};

/// Modes of the shop's machine; empty: a scenario is shown.
std::vector<stability::Mode> ownModes(TrainingPicture& picture, const project::PanelState& state, Stores& stores,
                                      const Progress& progress)
{
    auto response = chatter_common::takeResponse(state, stores, progress.part(0, 0.5, LT_TEXT("Engine", "Reading")));
    if (!response) return picture.question.modes;
    const Frf frf = chatter_common::noted(picture, std::move(response->taken));
    const auto fit =
        stores.of<FitMemo>()->find(response->basis, progress.part(0.5, 1, LT_TEXT("Engine", "Fitting modes")),
                                   [&](const Progress& fitting) { return receptance::fitModes(frf, {}, fitting); });
    picture.notes.insert(picture.notes.end(), fit->notes.begin(), fit->notes.end());
    if (fit->modes.empty()) throw Error(errors::modesNeeded, {});
    std::vector<stability::Mode> modes;
    modes.reserve(fit->modes.size());
    for (const receptance::FittedMode& fitted : fit->modes)
        modes.push_back({fitted.mode.frequency_hz, fitted.mode.damping_ratio, fitted.mode.stiffness_N_mm});
    picture.notes.push_back(
        {notes::modesFitted,
         {{"count", static_cast<std::int64_t>(modes.size())}, {"error_percent", fit->error_rms_percent}}});
    return modes;
}

void setDepths(training::Scenario& scenario, double least_limit_mm)
{
    scenario.greatest_depth_mm = shownDepth * least_limit_mm;
    scenario.start_depth_mm = startDepth * least_limit_mm;
}

void nameAssumed(TrainingPicture& picture)
{
    if (picture.scenario.key != training::ownScenario) return;
    if (!picture.question.cutting_coefficient_N_mm2)
        picture.used.push_back({"cutting_coefficient_N_mm2", LT_TEXT("Engine", "Cutting coefficient K_r"),
                                picture.scenario.cutting_coefficient_N_mm2, unit::N_mm2});
    if (!picture.question.feed_mm_rev)
        picture.used.push_back({"feed_mm_rev", LT_TEXT("Engine", "Feed"), picture.scenario.feed_mm_rev, unit::mm_rev});
}

}  // namespace

TrainingPicture trainingPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    TrainingPicture picture;
    picture.question = fromValues<TrainingQuestion>(state.parameters);
    const TrainingQuestion& question = picture.question;
    picture.scenario = scenarioOf(question, ownModes(picture, state, stores, progress.part(0, 0.4)));
    const training::Scenario& scenario = picture.scenario;
    nameAssumed(picture);
    std::string basis;
    for (const stability::Mode& mode : scenario.modes) basis += toJson(toValues(mode)).dump();
    for (const double number : {scenario.cutting_coefficient_N_mm2, scenario.speed_rpm.from, scenario.speed_rpm.to})
        basis += Json(number).dump() + ' ';
    picture.limits = stores.of<LimitsMemo>()->find(basis, progress.part(0.4, 0.7, LT_TEXT("Engine", "Finding lobes")),
                                                   [&](const Progress& p) { return training::limitsOf(scenario, p); });
    if (scenario.key == training::ownScenario || question.cutting_coefficient_N_mm2)
        setDepths(picture.scenario, picture.limits->exact.minimum_depth_mm.value_or(1));
    picture.frf = std::make_shared<const Frf>(stability::frfOf(scenario.modes, scenario.speed_rpm.to));
    picture.point = {question.speed_rpm.value_or(scenario.start_speed_rpm),
                     question.depth_mm.value_or(scenario.start_depth_mm)};
    picture.cut = std::make_shared<const stability::SimulationResult>(
        simulate(scenario.modes, training::cutOf(scenario, picture.point.speed_rpm, picture.point.depth_mm),
                 progress.part(0.7, 1, LT_TEXT("Engine", "Simulating"))));
    picture.state = training::stateOf(scenario, *picture.limits, question.relation, *picture.cut);
    return picture;
}

report::Answer answer(const TrainingPicture& picture, const Language& language)
{
    const stability::SimulationResult& cut = *picture.cut;
    const training::LessonState& state = picture.state;
    report::Answer answer;
    answer.values = {{"speed", fixed(picture.point.speed_rpm, 0, language)},
                     {"depth_mm", picture.point.depth_mm},
                     {"frequency", fixed(cut.frequency_hz, 1, language)},
                     {"limit_mm", state.limit_mm},
                     {"k", fixed(state.k, 0, language)},
                     {"phase", fixed(state.phase_deg, 0, language)}};
    answer.used = picture.used;
    if (picture.question.hide_chart) {
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

double highestShown(const TrainingPicture& picture)
{
    double highest = 0;
    for (const stability::Mode& mode : picture.scenario.modes) highest = std::max(highest, mode.frequency_hz);
    return shownSpectrum * highest;
}

stability::RasterParameters rasterOf(const TrainingPicture& picture)
{
    stability::RasterParameters p;
    p.cutting_coefficient_N_mm2 = picture.scenario.cutting_coefficient_N_mm2;
    p.speed_rpm = picture.scenario.speed_rpm;
    p.depth_mm = {0, picture.scenario.greatest_depth_mm};
    return p;
}

report::Document reportOf(const TrainingPicture& picture, const Language& language, const Progress& progress)
{
    stability::RasterParameters asked = rasterOf(picture);
    asked.columns = asked.rows = reportColumns;
    const stability::RasterResult raster = stabilityRaster(picture.scenario.modes, asked, progress);
    const stability::SimulationResult& cut = *picture.cut;
    report::Document document;
    document.title = LT_TEXT("Engine", "Training: a cut and its chatter");
    document.verification = {&stability::stabilityVerification()};
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    report::Section first{LT_TEXT("Engine", "Result"), {answer(picture, language)}};
    first.blocks.emplace_back(report::Paragraph{picture.scenario.description, {}});
    first.blocks.emplace_back(growthChart(picture.lobes(), &raster, picture.point, language));
    if (!picture.notes.empty()) first.blocks.emplace_back(picture.notes);
    document.sections.push_back(std::move(first));
    document.sections.push_back(
        {LT_TEXT("Engine", "The cut"),
         {report::quantityTable(LT_TEXT("Engine", "Simulated cut"), cut,
                                {"verdict_words", "growth_per_revolution", "frequency_hz", "wave_turns", "amplitude_mm",
                                 "lost_contact_percent"}),
          waveformPlot(cut), amplitudePlot(cut), wavesPlot(cut, cut.waves, language),
          surfaceMap(cut, revolutionsOf(cut) - 1), spectrumPlot(cut, highestShown(picture), language)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Published relation against the exact one"),
         {comparisonChart(picture.limits->exact, picture.limits->published, &raster, picture.point, language)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::parametersTable(picture.question, language), report::parametersTable(cut.parameters, language)}});
    return document;
}

}  // namespace lathelier::training_panel
