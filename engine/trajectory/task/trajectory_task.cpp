#include "engine/trajectory/task/trajectory_task.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/form/roundness/no_filter.h"
#include "engine/form/roundness/roundness_dfq.h"
#include "engine/task/memo.h"
#include "engine/trajectory/section_file.h"
#include "engine/trajectory/task/motion_report.h"
#include "engine/trajectory/trajectory_quantities.h"
#include "engine/trajectory/trajectory_report.h"

namespace lathelier::trajectory {
namespace {

constexpr double recordReadingShare = 0.4;  ///< of the progress
constexpr int signalPoints = 200000;        ///< of a channel: single turns have to be seen when zoomed in

struct TimeSignals : Memo<std::vector<TimeSignal>> {};

/// A started answer: the records, without their evaluation.
struct Begun {
    TrajectoryParameters parameters;
    TakenRecords records;
};

Begun begin(TrajectoryOutcome& outcome, const project::PanelState& state, Stores& stores, task::Sources& sources,
            const Progress& progress)
{
    outcome.question = fromValues<TrajectoryQuestion>(state.parameters);
    const TrajectoryQuestion& question = outcome.question;
    form::checkFilter(question.no_filter, question.parameters.form);
    Begun begun{question.parameters, takeRecords(state, stores, sources, progress)};
    outcome.records = begun.records.files;
    return begun;
}

void finish(TrajectoryOutcome& outcome, const project::PanelState& state, const task::Sources& sources)
{
    if (outcome.trajectory) {
        const Value* const wanted = find(state.parameters, sectionKey);
        const auto* const number = wanted ? std::get_if<std::int64_t>(wanted) : nullptr;
        outcome.section =
            sectionIndex(*outcome.trajectory, number ? std::optional(static_cast<int>(*number)) : std::nullopt);
    }
    outcome.record(state, sources, outcome.trajectory ? outcome.trajectory->notes : Notes{});
}

/// None without a limit; undecided where only averages are known.
std::optional<Verdict> motionVerdict(const TrajectoryOutcome& outcome, const TrajectorySection& section)
{
    const std::optional<double>& limit_um = outcome.question.error_motion_limit_um;
    if (!limit_um) return std::nullopt;
    if (!std::isfinite(section.spindle.total_um)) return Verdict::Undecided;
    return judge(section.spindle.total_um, section.spindle.total_expanded_uncertainty_um, *limit_um,
                 outcome.question.parameters.form.decision);
}

/// The worst of all sections.
std::optional<Verdict> motionVerdict(const TrajectoryOutcome& outcome)
{
    std::optional<Verdict> worst;
    for (const TrajectorySection& section : outcome.trajectory->sections)
        if (const auto found = motionVerdict(outcome, section)) worst = worst ? worse(*worst, *found) : *found;
    return worst;
}

/// The roundness of the worst section; with a limit of the motion that of the section where it is largest.
report::Answer answerOf(const TrajectoryOutcome& outcome, const Language& language)
{
    report::Answer told = answer(*outcome.trajectory, language);
    const std::optional<double>& limit_um = outcome.question.error_motion_limit_um;
    const std::vector<TrajectorySection>& sections = outcome.trajectory->sections;
    if (!limit_um || sections.empty()) return told;
    const auto total_um = [](const TrajectorySection& section) { return std::fmax(section.spindle.total_um, -1); };
    const TrajectorySection& most = *std::max_element(
        sections.begin(), sections.end(),
        [&](const TrajectorySection& a, const TrajectorySection& b) { return total_um(a) < total_um(b); });
    const bool has_uncertainty = std::isfinite(most.spindle.total_expanded_uncertainty_um);
    told.findings.push_back(
        {!std::isfinite(most.spindle.total_um)
             ? LT_TEXT("Engine", "Motion of the workpiece axis: only averages are known, limit {limit} µm")
         : has_uncertainty
             ? LT_TEXT("Engine",
                       "Motion of the workpiece axis {total:1} ± {U:1} µm, limit {limit} µm · section {section}")
             : LT_TEXT("Engine", "Motion of the workpiece axis {total:1} µm, limit {limit} µm · section {section}"),
         {{"total", most.spindle.total_um},
          {"U", most.spindle.total_expanded_uncertainty_um},
          {"limit", *limit_um},
          {"section", std::int64_t{most.section}}},
         motionVerdict(outcome),
         {}});
    return told;
}

/// The answer with what was judged of the motion, and the notes of the files as well as those of the result alone.
report::Section completed(report::Section summary, const TrajectoryOutcome& outcome, const Language& language)
{
    summary.blocks.front() = answerOf(outcome, language);
    if (!outcome.trajectory->notes.empty()) summary.blocks.pop_back();
    if (!outcome.notes.empty()) summary.blocks.emplace_back(outcome.notes);
    return summary;
}

report::Document reportOf(const TrajectoryOutcome& outcome, const Language& language)
{
    report::Document document = trajectoryReport(*outcome.trajectory, outcome.sources.inputs, language);
    document.sections.front() = completed(std::move(document.sections.front()), outcome, language);
    document.synthetic = outcome.sources.synthetic;
    return document;
}

Json jsonOf(const TrajectoryOutcome& outcome)
{
    Json json = toJson(*outcome.trajectory);
    const std::optional<Verdict> motion = motionVerdict(outcome);
    json["error_motion_verdict"] = motion ? Json(key(*motion)) : Json();
    return json;
}

/// What does not depend on whether the sections or the motion is asked for. `Outcome`: of either task.
template <class Outcome>
task::Outcome commonOf(const std::shared_ptr<const Outcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    if (!outcome->trajectory) return all;
    all.verdict = outcome->trajectory->verdict;
    if (const auto motion = motionVerdict(*outcome)) all.verdict = all.verdict ? worse(*all.verdict, *motion) : *motion;
    all.json = [outcome] { return jsonOf(*outcome); };
    all.writers[imagesExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        writeImages(path, *outcome->trajectory);
    };
    return all;
}

report::Answer answerOf(const MotionOutcome& outcome)
{
    const TrajectorySection* const section = outcome.chosenSection();
    if (!section) return {};
    report::Answer answer = motionAnswer(*outcome.trajectory, *section);
    answer.upper_limit = outcome.question.error_motion_limit_um;
    answer.verdict = motionVerdict(outcome, *section);
    return answer;
}

task::Task taskOfRecords()
{
    task::Task made;
    made.key = "trajectory";
    made.summary = "Evaluate probe records: trajectories, image of the surface, roundness, longitudinal section.";
    made.question = "roundness";
    made.inputs = {recordInput("")};
    task::askFor<TrajectoryQuestion>(made);
    return made;
}

task::Export imagesAsTable(Text label)
{
    return {imagesExport, "Write the images of the surface, point by point, as FILE.csv.", label,
            LT_TEXT("Engine", "Table (*.csv)"), "csv"};
}

}  // namespace

const std::vector<Field<TrajectoryQuestion>>& fieldsOf(const TrajectoryQuestion*)
{
    using Q = TrajectoryQuestion;
    static const auto all = [] {
        std::vector<Field<Q>> made{form::noFilterField(&Q::no_filter)};
        for (const FieldInfo& info : infos<TrajectoryParameters>()) made.push_back(within(&Q::parameters, info.key));
        made.push_back(field(
            "error_motion_limit_um", &Q::error_motion_limit_um, Range{0.001, 1e5},
            Label{LT_TEXT("Engine", "Error motion allowed"),
                  LT_TEXT("Engine", "Limit of the total error motion of the workpiece axis (ISO 230-7), probe X3."),
                  unit::um}));
        return made;
    }();
    return all;
}

const TrajectorySection* TrajectoryOutcome::chosenSection() const
{
    return trajectory && section ? &trajectory->sections[*section] : nullptr;
}

TrajectoryOutcome answerTrajectory(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                   const Progress& progress)
{
    TrajectoryOutcome outcome;
    const Begun begun = begin(outcome, state, stores, sources, progress.part(0, recordReadingShare));
    outcome.trajectory = evaluate(begun.records, begun.parameters, stores, progress.part(recordReadingShare, 1));
    finish(outcome, state, sources);
    return outcome;
}

MotionOutcome answerMotion(const project::PanelState& state, Stores& stores, task::Sources& sources,
                           const Progress& progress)
{
    MotionOutcome outcome;
    const Begun begun = begin(outcome, state, stores, sources, progress.part(0, recordReadingShare));
    if (const auto* const record = std::get_if<io::ProbeRecord>(&outcome.records.front()->file.record))
        outcome.time_signals = stores.of<TimeSignals>()->find(
            keyOf(begun.records, begun.parameters),
            progress.part(recordReadingShare, 0.5, LT_TEXT("Engine", "Signals")),
            [&](const Progress& part) { return timeSignals(*record, begun.parameters, signalPoints, part); });
    try {
        outcome.trajectory =
            evaluate(begun.records, begun.parameters, stores, progress.part(0.5, 1, LT_TEXT("Engine", "Trajectories")));
    } catch (const Error& error) {
        outcome.problem = error;
    }
    finish(outcome, state, sources);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const TrajectoryOutcome>& outcome)
{
    task::Outcome all = commonOf(outcome);
    all.answer = [outcome](const Language& language) { return answerOf(*outcome, language); };
    all.summary = [outcome](const Language& language) {
        return completed(trajectorySummary(*outcome->trajectory, language), *outcome, language);
    };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    all.writers[sectionsExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        writeSectionTable(path, *outcome->trajectory);
    };
    all.writers[sectionsQdasExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        std::vector<form::RoundnessResult> results;
        for (const TrajectorySection& section : outcome->trajectory->sections) results.push_back(section.roundness);
        io::writeDfq(path, form::qdasFile(results));
    };
    return settled(trajectoryTask(), std::move(all), outcome->understanding);
}

task::Outcome outcomeOf(const std::shared_ptr<const MotionOutcome>& outcome)
{
    task::Outcome all = commonOf(outcome);
    // Of the motion in the section that is shown, not of the roundness.
    const TrajectorySection* const section = outcome->chosenSection();
    all.verdict = section ? motionVerdict(*outcome, *section) : std::nullopt;
    all.answer = [outcome](const Language&) { return answerOf(*outcome); };
    if (outcome->problem)
        all.errors.push_back(*outcome->problem);
    else
        all.report = [outcome](const Language& language) {
            return motionReport(answerOf(*outcome), *outcome->trajectory, *outcome->chosenSection(), outcome->notes,
                                language);
        };
    return settled(motionTask(), std::move(all), outcome->understanding);
}

const task::Task& trajectoryTask()
{
    static const task::Task task = [] {
        task::Task made = taskOfRecords();
        made.title = LT_TEXT("Engine", "Longitudinal");
        made.exports = {
            {sectionsExport, "Write the table of the sections as FILE.csv.",
             LT_TEXT("Engine", "Table of all sections (CSV)…"), LT_TEXT("Engine", "Table (*.csv)"), "csv"},
            imagesAsTable({}),
            {sectionsQdasExport, "Write the deviations of the sections as Q-DAS characteristics (FILE.dfq).",
             LT_TEXT("Engine", "For statistical process control (Q-DAS)…"), LT_TEXT("Engine", "Q-DAS (*.dfq)"), "dfq"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(
                std::make_shared<const TrajectoryOutcome>(answerTrajectory(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

const task::Task& motionTask()
{
    static const task::Task task = [] {
        task::Task made = taskOfRecords();
        made.title = LT_TEXT("Engine", "Trajectory");
        made.exports = {imagesAsTable(LT_TEXT("Engine", "Trajectories and images of all sections (CSV)…"))};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const MotionOutcome>(answerMotion(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::trajectory
