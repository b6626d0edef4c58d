#include "engine/chain/remanufacture_task.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/cad/task/recognize_task.h"
#include "engine/cam/job_file.h"
#include "engine/chain/dossier_cover.h"
#include "engine/chain/dossier_kind.h"
#include "engine/chain/dossier_read.h"
#include "engine/chain/dossier_report.h"
#include "engine/chain/remanufacture.h"
#include "engine/core/core_codes.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/cloud/scan_input.h"
#include "engine/receptance/spindle/spindle_kind.h"
#include "engine/task/asked_state.h"

namespace lathelier::chain {
namespace {

constexpr const char* scanRole = "scan";

bool isOfRecognition(const std::string& key)
{
    const std::vector<std::string>& keys = recognitionKeys();
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Default values are omitted, as in the window, so that equal questions are recognised.
ChainQuestion questionOf(const project::PanelState& state)
{
    const task::Task& task = remanufactureTask();
    Values own;
    for (const auto& [key, value] : state.parameters)
        if (!isOfRecognition(key)) set(own, key, value);
    auto question = fromValues<ChainQuestion>(own);
    if (question.out.empty())
        throw Error(
            errors::valueNotUnderstood,
            {{"parameter", task::optionName("out")}, {"found", ""}, {"expected", LT_TEXT("Engine", "a folder")}});
    const project::Source& scan = state.inputs.at(scanRole);
    question.scan = scan.path;
    for (const auto& [key, value] : state.parameters)
        if (isOfRecognition(key) && value != *find(task.defaults, key)) set(question.recognition, key, value);
    Values standard = lathelier::toValues(io::ImportOptions{});
    for (const io::FileKind* kind : task.inputs.front().kinds)
        for (const auto& [key, value] : kind->reading_defaults) set(standard, key, value);
    for (const auto& [key, value] : scan.import)
        if (const Value* const usual = find(standard, key); !usual || *usual != value)
            set(question.reading, key, value);
    return question;
}

/// What reused steps assumed: their notes are those of the earlier run.
void addAssumedEarlier(const Dossier& dossier, Understanding& understanding)
{
    for (const ChainStep& step : dossier.steps) {
        if (!step.past_notes || !step.understanding || !step.understanding->contains("assumed")) continue;
        for (const Json& one : (*step.understanding)["assumed"]) {
            const auto wordOf = [&](const char* key) {
                return one.contains(key) && one[key].is_string() ? one[key].get<std::string>() : std::string();
            };
            const bool has_line = one.contains("line") && one["line"].is_number_integer();
            understanding.assumed.push_back(
                {wordOf("what"), wordOf("value"), wordOf("path"), has_line ? one["line"].get<std::int64_t>() : 0});
        }
    }
}

task::Outcome outcomeOf(const std::shared_ptr<const Dossier>& dossier)
{
    task::Outcome all;
    all.result = dossier;
    all.notes = dossier->notes;
    all.verdict = dossier->verdict;
    if (const auto error = dossier->error()) all.errors.push_back(*error);
    all.json = [dossier] { return toJson(*dossier); };
    all.answer = [dossier](const Language&) { return answer(*dossier); };
    all.summary = [dossier](const Language&) { return report::Section{{}, {answer(*dossier), stepsTable(*dossier)}}; };
    all.report = [dossier](const Language& language) { return dossierReport(*dossier, language); };
    Understanding understanding = lathelier::understandingOf(all.notes);
    addAssumedEarlier(*dossier, understanding);
    return settled(remanufactureTask(), std::move(all), understanding);
}

task::Outcome run(const project::PanelState& state, task::Sources& sources, const Progress& progress)
{
    const ChainQuestion question = questionOf(state);
    std::shared_ptr<const Dossier> earlier;
    if (question.resume)
        if (auto found = dossierIn(question.out, progress))
            earlier = std::make_shared<const Dossier>(*std::move(found));
    io::InputFiles inputs;
    const auto list = [&] { sources.inputs = inputs.list(); };
    try {
        inputs.open(question.scan, progress);
        inputs.drop();
        const RunMode mode = question.resume ? RunMode::OutOfDate : RunMode::Everything;
        auto dossier = std::make_shared<const Dossier>(remanufacture(question, mode, earlier, inputs, progress));
        list();
        // Dossier and report are in the folder in any case.
        writeDossier(question, *dossier, inputs.list(), parametersOf(remanufactureTask(), state));
        return outcomeOf(dossier);
    } catch (...) {
        list();
        throw;
    }
}

}  // namespace

const task::Task& remanufactureTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "remanufacture";
        made.title = LT_TEXT("Engine", "Chain");
        made.summary =
            "From the scan of a worn part to its drawing, its program and the proof of its copy, in one folder.";
        made.question = "proof";
        made.inputs = {task::ofPart(task::input<io::ScanInput>(
            scanRole, "", LT_TEXT("Engine", "Scan"), LT_TEXT("Engine", "The worn part: a point cloud or mesh.")))};
        made.inputs.front().kinds = {&io::scanFiles(), &cam::jobFiles(), &receptance::spindleFiles(),
                                     &deflection::setupFiles(), &dossierFiles()};
        task::askFor<ChainQuestion>(made);
        const cad::RecognizeQuestion usual;
        for (const Field<cad::RecognizeQuestion>& field : fields<cad::RecognizeQuestion>())
            if (isOfRecognition(field.info.key)) {
                made.fields.push_back(field.info);
                made.defaults.emplace_back(field.info.key, field.get(usual));
            }
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores&, task::Sources& sources,
                      const Progress& progress) { return run(state, sources, progress); };
        return made;
    }();
    return task;
}

}  // namespace lathelier::chain
