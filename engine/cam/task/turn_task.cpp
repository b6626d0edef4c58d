#include "engine/cam/task/turn_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/cad/part_input.h"
#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_files.h"
#include "engine/cam/plan_outcome.h"
#include "engine/cam/plan_refusal.h"
#include "engine/cam/plan_report.h"
#include "engine/cam/task/job_input.h"
#include "engine/cam/task/job_places.h"
#include "engine/cam/task/setup_sheet.h"
#include "engine/core/frf_item.h"
#include "engine/gcode/program_input.h"
#include "engine/gcode/program_item.h"
#include "engine/receptance/spindle/spindle_input.h"

namespace lathelier::cam {
namespace {

constexpr std::size_t originDigits = 12;  // of digests in the head of a program
constexpr std::size_t mostReportedFindings = 3;

/// Where no job is given, the file of the part is one.
project::PanelState withJob(project::PanelState state)
{
    const project::Source* const part = task::sourceOf(state, partRole);
    if (state.inputs.count(jobRole) > 0 || hasTools(state) || !part || !part->item.empty()) return state;
    state.inputs[jobRole] = *part;
    state.inputs.erase(partRole);
    return state;
}

Job takeJob(TurnOutcome& outcome, const project::PanelState& state, Stores& stores, task::Sources& sources,
            const Progress& progress)
{
    Job job = outcome.question.job;
    const std::optional<Job> of_file = task::take<JobInput>(state, jobRole, stores, progress, sources);
    if (!of_file) return job;
    outcome.is_changed = formRules(outcome.question, state);
    if (!outcome.is_changed) return *of_file;
    job.shaft = of_file->shaft;
    if (!(job == *of_file))
        sources.notes.push_back({notes::jobChanged, {{"source", task::nameOf(state.inputs.at(jobRole))}}});
    return job;
}

Shaft takePart(const Job& job, const project::PanelState& state, Stores& stores, task::Sources& sources,
               const Progress& progress)
{
    if (auto part = task::take<cad::PartInput>(state, partRole, stores, progress, sources)) return *std::move(part);
    if (job.shaft) return *job.shaft;
    const project::Source* const source = task::sourceOf(state, jobRole);
    throw Error(errors::jobWithoutShaft, {{"path", source ? task::nameOf(*source) : std::string()}});
}

bool isFile(const std::string& stated)
{
    std::error_code ignored;
    return stated.find_first_of("./\\") != std::string::npos || std::filesystem::exists(stated, ignored);
}

Post takePost(TurnOutcome& outcome, project::PanelState state, Stores& stores, task::Sources& sources,
              const Progress& progress)
{
    const std::string& stated = outcome.question.post;
    const std::vector<std::string> names = postNames();
    if (state.inputs.count(postRole) == 0) {
        if (std::find(names.begin(), names.end(), stated) != names.end() || !isFile(stated)) return postNamed(stated);
        state.inputs[postRole].path = stated;
    }
    outcome.has_own_post = true;
    return *task::take<PostInput>(state, postRole, stores, progress, sources);
}

/// Files of the part and the job with their digests, for the head of the program.
std::vector<std::string> originOf(const project::PanelState& state, const task::Sources& sources)
{
    std::vector<std::string> lines;
    for (const InputFile& input : sources.inputs)
        for (const char* role : {jobRole, partRole}) {
            const project::Source* const source = task::sourceOf(state, role);
            if (source && task::nameOf(*source) == input.path)
                lines.push_back(std::string(role) + " SHA-256 " + input.sha256.substr(0, originDigits));
        }
    return lines;
}

void writeAll(const TurnOutcome& outcome, const std::string& path)
{
    requireWritable(outcome);
    const std::vector<std::string> paths = programPaths(path, outcome.programs.size());
    refuseInputs(paths, outcome.sources.inputs, paths.front());
    for (std::size_t i = 0; i < paths.size(); ++i) outcome.plan->setups[i].program = paths[i];
    writePrograms(*outcome.plan, paths);
}

void writeAllRefused(const TurnOutcome& outcome, const std::string& path)
{
    const std::vector<std::string> paths = programPaths(path, outcome.programs.size());
    std::vector<std::string> written;
    written.reserve(paths.size());
    for (const std::string& planned : paths) written.push_back(refusedPath(planned));
    refuseInputs(written, outcome.sources.inputs, written.front());
    writeRefused(*outcome.plan, paths);
}

}  // namespace

bool TurnOutcome::isVoid() const
{
    return std::any_of(programs.begin(), programs.end(), [](const ShownProgram& program) { return program.is_void; });
}

TurnOutcome answerTurn(const project::PanelState& stated, bool keeps_outlines, Stores& stores, task::Sources& sources,
                       const Progress& progress)
{
    const project::PanelState state = withJob(stated);
    TurnOutcome outcome;
    outcome.question = fromValues<TurningQuestion>(state.parameters);
    const Progress reading = progress.part(0, 0.1, LT_TEXT("Engine", "Reading"));
    const Job job = takeJob(outcome, state, stores, sources, reading.part(0, 0.2));
    const auto located = [&](auto work) {
        try {
            return work();
        } catch (Error& error) {
            if (!outcome.is_changed) locateInJob(error, state, job);
            throw;
        }
    };
    const Shaft part = located([&] { return takePart(job, state, stores, sources, reading.part(0.2, 0.6)); });
    TurningInputs inputs;
    inputs.post = takePost(outcome, state, stores, sources, reading.part(0.6, 0.7));
    inputs.keeps_outlines = keeps_outlines;
    inputs.spindle = task::take<receptance::SpindleInput>(state, spindleRole, stores, reading.part(0.7, 1), sources);
    inputs.origin = originOf(state, sources);
    if (const auto& length_mm = part.recovered.stated_length_mm)
        inputs.origin.push_back(fmt::format("length {:.3f} stated, an end is not seen", *length_mm));
    TurningPlan planned =
        located([&] { return planTurning(part, job, inputs, outcome.question.plan, progress.part(0.1, 0.8)); });
    const std::vector<GivenProgram> given = chooseProgram(outcome, planned, state, stores, sources, reading);
    outcome.plan =
        std::make_shared<TurningPlan>(withPrograms(std::move(planned), given, inputs, progress.part(0.8, 1)));
    Understanding of_programs;  // those planned here hold nothing else
    for (std::size_t i = 0; i < outcome.programs.size(); ++i)
        if (const ShownProgram& shown = outcome.programs[i]; shown.is_changed || shown.origin != ProgramOrigin::Planned)
            of_programs.add(outcome.plan->setups[i].check.path.understanding,
                            shown.name.empty() ? outcome.plan->job.title : shown.name);
    outcome.record(stated, sources, outcome.plan->notes, of_programs);
    return outcome;
}

void requireWritable(const TurnOutcome& outcome)
{
    for (std::size_t i = 0; i < outcome.programs.size(); ++i) {
        if (outcome.programs[i].is_void)
            throw Error(errors::checkVoid, {{"clamping", static_cast<std::int64_t>(i) + 1}});
        if (const int tool = unknownToolOf(outcome.plan->setups[i].check); tool != 0)
            throw Error(errors::cutsNotChecked,
                        {{"clamping", static_cast<std::int64_t>(i) + 1}, {"tool", std::int64_t{std::max(0, tool)}}});
    }
    throwIfRefused(*outcome.plan);
}

report::Answer answer(const TurnOutcome& outcome, const Language& language)
{
    const TurningPlan& plan = *outcome.plan;
    report::Answer answer = cam::answer(plan, language);
    if (outcome.isVoid()) {
        answer.verdict_words = LT_TEXT("Engine", "? check void");
        answer.sentence = LT_TEXT("Engine", "A program was changed after its check: check it again.");
        answer.value.reset();
        answer.values.clear();
        return answer;
    }
    const bool is_corrected = std::any_of(outcome.programs.begin(), outcome.programs.end(),
                                          [](const ShownProgram& p) { return p.origin == ProgramOrigin::Corrected; });
    if (is_corrected && plan.verdict && !plan.is_refused && plan.not_made.empty())
        answer.verdict_words = plan.rest.empty() ? LT_TEXT("Engine", "✓ compensated, checked")
                                                 : LT_TEXT("Engine", "✗ compensated; material stays");
    for (const SetupPlan& setup : plan.setups)
        for (const CheckFinding& found : setup.check.findings) {
            if (answer.findings.size() == mostReportedFindings) break;
            report::Finding& reported = answer.findings.emplace_back();
            reported.pattern = LT_TEXT("Engine", "Line {line}: {kind} at z = {z_mm:1} mm, {depth_mm:2} mm deep");
            reported.values = {
                {"line", found.line}, {"kind", nameOf(found.kind)}, {"z_mm", found.z_mm}, {"depth_mm", found.depth_mm}};
            reported.verdict = Verdict::Fail;
            reported.place.line = found.line;
        }
    for (const DrawnFeature& feature : plan.not_made) {
        if (answer.findings.size() == mostReportedFindings) break;
        report::Finding& reported = answer.findings.emplace_back();
        reported.pattern =
            LT_TEXT("Engine", "Not in the program: {feature} {designation} · z {z_start_mm:2}-{z_end_mm:2} mm");
        reported.values = valuesOf(feature);
        reported.verdict = Verdict::Fail;
        if (feature.z_start_mm && feature.z_end_mm)
            reported.place.z_mm = Interval{*feature.z_start_mm, *feature.z_end_mm};
    }
    std::vector<const RestInterval*> largest;
    for (const RestInterval& rest : plan.rest) largest.push_back(&rest);
    std::stable_sort(largest.begin(), largest.end(),
                     [](const auto* a, const auto* b) { return a->left_mm > b->left_mm + meet_mm; });
    for (const RestInterval* rest : largest) {
        if (answer.findings.size() == mostReportedFindings) break;
        report::Finding& reported = answer.findings.emplace_back();
        reported.pattern = LT_TEXT("Engine", "Left {left_mm:3} mm · z {from:2}-{to:2} mm · {cause}");
        reported.values = {{"left_mm", rest->left_mm},
                           {"from", rest->z_start_mm},
                           {"to", rest->z_end_mm},
                           {"cause", nameOf(rest->cause)}};
        reported.verdict = Verdict::Fail;
        reported.place.z_mm = Interval{rest->z_start_mm, rest->z_end_mm};
    }
    return answer;
}

task::Outcome outcomeOf(const std::shared_ptr<const TurnOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.verdict = outcome->plan->verdict;
    all.answer = [outcome](const Language& language) { return answer(*outcome, language); };
    all.report = [outcome](const Language& language) {
        TurningPlan whole = *outcome->plan;
        whole.notes = outcome->notes;
        report::Document document = planReport(whole, language);
        document.sections.front().blocks.front() = answer(*outcome, language);
        return document;
    };
    try {
        throwIfRefused(*outcome->plan);
    } catch (Error& error) {
        for (std::size_t i = 0; i < outcome->programs.size(); ++i)  // an error of a given program is in its own file
            if (outcome->plan->setups[i].check.path.has_errors && !outcome->programs[i].name.empty())
                error.with("path", outcome->programs[i].name);
        all.errors.push_back(error);
        all.writers[programExport] = [outcome](const std::string& path, const Language&, const Progress&) {
            writeAllRefused(*outcome, path);
        };
        return settled(turnTask(), std::move(all), outcome->understanding);
    }
    all.json = [outcome] { return toJson(*outcome->plan); };
    all.summary = [outcome](const Language& language) { return planSummary(*outcome->plan, language); };
    all.products = [outcome](const Language& language) { return productsOf(outcome, language); };
    all.writers[programExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        writeAll(*outcome, path);
    };
    all.writers[sheetExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        writeSetupSheet(*outcome, path);
    };
    return settled(turnTask(), std::move(all), outcome->understanding);
}

const task::Task& turnTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "turn";
        made.title = LT_TEXT("Engine", "Turning program");
        made.summary =
            "Plan a turning program from a part and a job, write it for a control, and check what was written.";
        made.question = "program";
        made.products = {gcode::programItem, frfItem};
        made.inputs = {
            task::input<cad::PartInput>(
                partRole, "", LT_TEXT("Engine", "Shaft"),
                LT_TEXT("Engine", "The part (SHAFT.json, STEP, CSV) with --job, or a job that holds its shaft.")),
            task::optionalInput<JobInput>(
                jobRole, jobRole, LT_TEXT("Engine", "Job"),
                LT_TEXT("Engine",
                        "Stock, set-up, tools and cutting data, from JOB.json; without it the operand is a job that "
                        "holds its shaft.")),
            task::optionalInput<receptance::SpindleInput>(
                spindleRole, spindleRole, LT_TEXT("Engine", "Spindle"),
                LT_TEXT("Engine", "Machine at the chuck face, from SPINDLE.json: speeds follow its dynamics.")),
            task::optionalInput<PostInput>(postRole, postRole, LT_TEXT("Engine", "Control of your own"),
                                           LT_TEXT("Engine", "POST.json, in place of a control that is built in.")),
            task::optionalInput<gcode::ProgramInput>(
                programRole, programRole, LT_TEXT("Engine", "Program in place of the planned one"),
                LT_TEXT("Engine", "In place of the planned program of the first clamping; it is checked like it."))};
        made.inputs.front().operand = "SHAFT|JOB";
        made.inputs.front().is_of_part = true;
        made.inputs.back().is_of_part = true;
        made.inputs.back().item_kind = gcode::correctedItem;
        task::askFor<TurningQuestion>(made);
        made.exports = {
            {programExport,
             "Write the program as FILE; two clampings as FILE_1 and FILE_2. What the check refuses stands beside as "
             "FILE.refused, with a stop in its first line.",
             {},
             {},
             "nc",
             true},
            {sheetExport,
             "Write the set-up sheet as FILE.html: clamping, zero, tools, operations, stops, what is left.",
             {},
             {},
             "html",
             true}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const TurnOutcome>(answerTurn(state, false, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::cam
