#include "engine/cam/task/check_task.h"

#include <nlohmann/json.hpp>

#include "engine/cad/part_input.h"
#include "engine/cam/cam_codes.h"
#include "engine/cam/check/check_report.h"
#include "engine/cam/drawn_features.h"
#include "engine/cam/task/job_input.h"
#include "engine/cam/task/job_places.h"
#include "engine/cam/task/turn_question.h"
#include "engine/gcode/program_input.h"

namespace lathelier::cam {
namespace {

constexpr const char* correctionRole = "correction";
constexpr const char* beforeRole = "before";

[[noreturn]] void throwWithoutShaft(const project::PanelState& state, const Job& job)
{
    Error error(errors::jobWithoutShaft, {{"path", task::nameOf(state.inputs.at(jobRole))}});
    locateInJob(error, state, job);
    throw Error(error);
}

}  // namespace

CheckOutcome answerCheck(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress)
{
    const Progress reading = progress.part(0, 0.08, LT_TEXT("Engine", "Reading"));
    CheckOutcome outcome;
    const Job job = *task::take<JobInput>(state, jobRole, stores, reading, sources);
    if (auto part = task::take<cad::PartInput>(state, partRole, stores, reading, sources))
        outcome.part = *std::move(part);
    else if (job.shaft)
        outcome.part = *job.shaft;
    else
        throwWithoutShaft(state, job);
    CheckInputs further;
    further.correction = task::take<CorrectionInput>(state, correctionRole, stores, reading, sources)
                             .value_or(gcode::StatedCorrection{});
    if (auto before = task::take<gcode::ProgramInput>(state, beforeRole, stores, reading, sources))
        further.before = std::move(before->text);
    auto parameters = fromValues<CheckParameters>(state.parameters);
    parameters.program.file_name = task::nameOf(state.inputs.at(programRole));
    gcode::ProgramText program = *task::take<gcode::ProgramInput>(state, programRole, stores, reading, sources);
    gcode::takeSubprograms(program.text, parameters.program, {}, progress, sources);
    try {
        outcome.result = std::make_shared<const CheckResult>(
            checkTurning(std::move(program.text), outcome.part, job, parameters, further, progress.part(0.08, 1)));
    } catch (Error& error) {
        locateInJob(error, state, job);
        throw error.with("path", task::nameOf(state.inputs.at(programRole)));
    }
    Understanding of_programs;
    of_programs.add(outcome.result->path.understanding, task::nameOf(state.inputs.at(programRole)));
    if (const project::Source* const before = task::sourceOf(state, beforeRole))
        of_programs.add(outcome.result->before_understanding, task::nameOf(*before));
    // What is drawn and not looked at cannot turn a failure into a pass.
    const GapEffect effect = outcome.result->verdict == Verdict::Fail ? GapEffect::None : GapEffect::Measures;
    const std::string drawing = task::nameOf(state.inputs.at(state.inputs.contains(partRole) ? partRole : jobRole));
    for (const DrawnFeature& feature : outcome.result->not_checked)
        of_programs.not_modelled.push_back({drawing, 0, 0, plainText(feature), notes::drawnNotChecked.key, effect});
    outcome.record(state, sources, outcome.result->notes, of_programs);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const CheckOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.verdict = outcome->result->verdict;
    if (std::optional<Error> error = gcode::firstError(outcome->result->path)) {
        error->with("path", task::nameOf(outcome->asked.inputs.at(programRole)));
        all.errors.push_back(*error);
    }
    all.json = [outcome] { return toJson(*outcome->result); };
    all.answer = [outcome](const Language& language) { return answer(*outcome->result, language); };
    all.summary = [outcome](const Language& language) { return checkSummary(*outcome->result, language); };
    all.report = [outcome](const Language& language) {
        CheckResult whole = *outcome->result;
        whole.notes = outcome->notes;
        return checkReport(whole, outcome->part, language);
    };
    return settled(checkTask(), std::move(all), outcome->understanding);
}

const task::Task& checkTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "check";
        made.title = LT_TEXT("Engine", "Check");
        made.question = "program";
        made.summary =
            "Check a turning program against its drawing and its stock: what it cuts too deep, leaves and meets.";
        made.inputs = {
            gcode::programAsInput(),
            task::input<JobInput>(jobRole, jobRole, LT_TEXT("Engine", "Job"),
                                  LT_TEXT("Engine", "Stock, set-up, tools and cutting data, from JOB.json.")),
            task::optionalInput<cad::PartInput>(
                partRole, partRole, LT_TEXT("Engine", "Shaft"),
                LT_TEXT("Engine", "The part, from FILE (SHAFT.json, STEP, CSV), instead of the one in the job.")),
            task::optionalInput<CorrectionInput>(
                correctionRole, correctionRole, LT_TEXT("Engine", "Correction"),
                LT_TEXT("Engine",
                        "What the program was corrected by: FILE that deflection --compensate wrote with --json.")),
            task::optionalInput<gcode::ProgramInput>(
                beforeRole, beforeRole, LT_TEXT("Engine", "Program before"),
                LT_TEXT("Engine", "The program of the first clamping, for --setup 2."))};
        task::askFor<CheckParameters>(made);
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const CheckOutcome>(answerCheck(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::cam
