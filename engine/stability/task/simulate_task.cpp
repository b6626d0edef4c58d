#include "engine/stability/task/simulate_task.h"

#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/stability/simulation/response_modes.h"
#include "engine/stability/simulation/simulation_files.h"
#include "engine/stability/simulation/simulation_report.h"
#include "engine/stability/task/point_modes.h"

namespace lathelier::stability {
const std::vector<Field<SimulateQuestion>>& fieldsOf(const SimulateQuestion*)
{
    using Q = SimulateQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<Field<Q>> made;
        for (const FieldInfo& info : infos<SimulationParameters>()) made.push_back(within(&Q::cut, info.key));
        for (const FieldInfo& info : infos<ResponseQuestion>()) made.push_back(within(&Q::response, info.key));
        return made;
    }();
    return all;
}

SimulateOutcome answerSimulate(const project::PanelState& state, Stores& stores, task::Sources& sources,
                               const Progress& progress)
{
    SimulateOutcome outcome;
    outcome.question = fromValues<SimulateQuestion>(state.parameters);
    outcome.response = takeResponse(state, outcome.question.response, usualHighestSpeed_rpm, std::nullopt, stores,
                                    sources, progress.part(0, 0.05));
    Notes found;
    const SimulationParameters& cut = outcome.question.cut;
    outcome.modes = modesOfPoint(
        outcome.response, cut.cutting_coefficient_N_mm2.value_or(0) * cut.depth_mm.value_or(0) * cut.direction_factor,
        stores, found, progress.part(0.05, 0.1, LT_TEXT("Engine", "Fitting modes")));
    SimulationResult result = simulate(outcome.modes, cut, progress.part(0.1, 1, LT_TEXT("Engine", "Simulating")));
    if (outcome.response.modes.empty()) judgeModel(result, outcome.modes, *outcome.response.frf);
    outcome.result = std::make_shared<const SimulationResult>(std::move(result));
    found.insert(found.end(), outcome.result->notes.begin(), outcome.result->notes.end());
    outcome.record(state, sources, found);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const SimulateOutcome>& outcome)
{
    const std::shared_ptr<const SimulationResult> result = outcome->result;
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.json = [outcome] {
        Json json = nestedJson(describedValues(*outcome->result));
        addUsedLines(outcome->response, json);
        return json;
    };
    all.answer = [result](const Language& language) { return answer(*result, language); };
    all.summary = [result](const Language& language) { return simulationSummary(*result, language); };
    all.report = [outcome](const Language& language) {
        SimulationResult whole = *outcome->result;
        whole.notes = outcome->notes;
        report::Document document = simulationReport(whole, language);
        std::get<report::Answer>(document.sections.front().blocks.front()).used = outcome->response.used;
        return document;
    };
    all.writers[waveformExport] = [result](const std::string& path, const Language&, const Progress& progress) {
        io::writeFile(path, [&](const io::Append& append) {
            writeWaveform(*result, [&](std::string_view step) {
                progress.check();
                append(step);
            });
        });
    };
    all.writers[soundExport] = [result](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, soundOf(*result).bytes);
    };
    return settled(simulateTask(), std::move(all), outcome->understanding);
}

const task::Task& simulateTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "simulate";
        made.title = LT_TEXT("Engine", "Simulation");
        made.summary = "Simulate a cut in time, with loss of contact: does it chatter?";
        made.question = "speed";
        made.inputs = responseInputs();
        made.one_of = responseSources();
        made.only_with = responseRules();
        task::askFor<SimulateQuestion>(made);
        made.exports = {
            {waveformExport, "Write the waveform as FILE.csv.", {}, {}, "csv"},
            {soundExport, "Write the vibration as sound, FILE.wav (16 bit, mono, 44.1 kHz).", {}, {}, "wav"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const SimulateOutcome>(answerSimulate(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::stability
