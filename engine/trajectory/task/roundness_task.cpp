#include "engine/trajectory/task/roundness_task.h"

#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/json.h"
#include "engine/form/roundness/no_filter.h"
#include "engine/form/roundness/roundness_dfq.h"
#include "engine/form/roundness/roundness_quantities.h"
#include "engine/form/roundness/roundness_report.h"
#include "engine/form/roundness/superimpose_report.h"
#include "engine/io/profile/profile_input.h"
#include "engine/task/memo.h"
#include "engine/task/read_key.h"
#include "engine/task/task_codes.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

constexpr double profileReadingShare = 0.3;  ///< of the progress of one profile

struct JudgedProfiles : Memo<form::RoundnessResult> {};
struct SuperimposedProfiles : Memo<form::SuperimposeResult> {};

struct TakenProfile {
    Profile profile;
    std::string key;  ///< content and how it was read
};

TakenProfile takeProfile(const project::PanelState& state, const std::string& role, Stores& stores,
                         task::Sources& sources, const Progress& progress)
{
    const std::size_t before = sources.inputs.size();
    TakenProfile taken{*task::take<io::ProfileInput>(state, role, stores, progress, sources), {}};
    taken.key = task::nameOf(state.inputs.at(role)) + "\n" + task::readKey(state, {role}, sources, before);
    return taken;
}

/// One run: what was found so far, and the notes in the order in which they were found.
class Judge {
public:
    Judge(const project::PanelState& state, form::MethodTable methods, Stores& stores, task::Sources& sources)
        : state_(state), methods_(methods), stores_(stores), sources_(sources)
    {
        outcome_.question = fromValues<RoundnessQuestion>(state.parameters);
        form::checkFilter(outcome_.question.no_filter, outcome_.question.form);
    }

    RoundnessOutcome answer(const Progress& progress)
    {
        const std::vector<std::string> profiles = project::keysOf(state_, profileRole);
        const bool is_laid = task::sourceOf(state_, traceRole) != nullptr;
        if (is_laid && profiles.size() > 1)
            throw Error(errors::valueNotUnderstood,
                        {{"parameter", "--superimpose"},
                         {"found", static_cast<std::int64_t>(profiles.size())},
                         {"expected", LT_TEXT("Engine", "one profile to lay the other on")}});
        const double share = 1.0 / (std::max(1.0, static_cast<double>(profiles.size())) + (is_laid ? 1 : 0));
        const Progress last = progress.part(1 - share, 1);
        if (profiles.empty()) {
            judgeSection(progress.part(0, is_laid ? 1 - share : 1));
            if (is_laid) superimpose(outcome_.chosenSection()->image, recordKey_, last);
        }
        for (std::size_t i = 0; i < profiles.size(); ++i) {
            const auto done = static_cast<double>(i);
            try {
                const TakenProfile taken = judge(profiles[i], progress.part(done * share, (done + 1) * share));
                if (is_laid) superimpose(taken.profile, taken.key, last);
            } catch (Error& error) {  // the other profiles are answered all the same
                note({});
                outcome_.errors.push_back(error.with("path", task::nameOf(state_.inputs.at(profiles[i]))));
            }
        }
        task::Sources in_order = sources_;
        in_order.notes = std::move(notes_);
        outcome_.record(state_, in_order, {});
        return std::move(outcome_);
    }

private:
    TakenProfile judge(const std::string& role, const Progress& progress)
    {
        const std::size_t before = notes_.size();
        TakenProfile taken = takeProfile(state_, role, stores_, sources_,
                                         progress.part(0, profileReadingShare, LT_TEXT("Engine", "Reading")));
        note({});
        const form::RoundnessParameters& parameters = outcome_.question.form;
        form::RoundnessResult result = *stores_.of<JudgedProfiles>()->find(
            taken.key + lathelier::toJson(toValues(parameters)).dump() +
                (methods_ == form::MethodTable::Made ? "methods" : ""),
            progress.part(profileReadingShare, 1, LT_TEXT("Engine", "Evaluating")),
            [&](const Progress& part) { return form::roundness(taken.profile, parameters, part, methods_); });
        note(result.notes);
        // The report and the profile's own notes hold those of its file as well.
        result.notes.assign(notes_.begin() + static_cast<std::ptrdiff_t>(before), notes_.end());
        add(std::move(result), task::nameOf(state_.inputs.at(role)));
        return taken;
    }

    void judgeSection(const Progress& progress)
    {
        const TakenRecords records = takeRecords(state_, stores_, sources_, progress.part(0, 0.4));
        if (records.files.empty()) throw Error(errors::oneNeeded, {{"names", roundnessTask().one_of.label}});
        const TrajectoryParameters parameters = outcome_.question.ofRecord();
        outcome_.trajectory =
            evaluate(records, parameters, stores_, progress.part(0.4, 1, LT_TEXT("Engine", "Trajectories")));
        note(outcome_.trajectory->notes);
        const std::optional<int>& asked = outcome_.question.section;
        outcome_.section = sectionIndex(*outcome_.trajectory, asked);
        const TrajectorySection& section = *outcome_.chosenSection();
        if (asked && section.section != *asked)
            note({{notes::sectionNotThere,
                   {{"section", std::int64_t{*asked}}, {"used", std::int64_t{section.section}}}}});
        recordKey_ = keyOf(records, parameters) + "\n" + std::to_string(section.section) + "\n";
        add(section.roundness, records.files.front()->inputs.front().path);
    }

    /// Lays the trace on `first`.
    void superimpose(const Profile& first, const std::string& key, const Progress& progress)
    {
        const TakenProfile other = takeProfile(state_, traceRole, stores_, sources_,
                                               progress.part(0, profileReadingShare, LT_TEXT("Engine", "Reading")));
        note({});
        form::SuperimposeParameters wanted;
        wanted.form = outcome_.question.form;
        wanted.mirrored = outcome_.question.mirrored;
        try {
            outcome_.superimposed = stores_.of<SuperimposedProfiles>()->find(
                key + other.key + lathelier::toJson(toValues(wanted.form)).dump() + (wanted.mirrored ? "mirrored" : ""),
                progress.part(profileReadingShare, 1),
                [&](const Progress& part) { return form::superimpose(first, other.profile, wanted, part); });
        } catch (Error& error) {
            error.with("path", task::nameOf(state_.inputs.at(traceRole)));  // the first profile was evaluated before
            throw;
        }
        note(outcome_.superimposed->notes);
    }

    void add(form::RoundnessResult result, const std::string& path)
    {
        if (result.name.empty()) result.name = path;
        outcome_.paths.push_back(path);
        outcome_.results.push_back(std::move(result));
    }

    /// Those that the readers left since the last call, then `of_result`.
    void note(const Notes& of_result)
    {
        notes_.insert(notes_.end(), sources_.notes.begin() + static_cast<std::ptrdiff_t>(read_), sources_.notes.end());
        read_ = sources_.notes.size();
        notes_.insert(notes_.end(), of_result.begin(), of_result.end());
    }

    const project::PanelState& state_;
    form::MethodTable methods_;
    Stores& stores_;
    task::Sources& sources_;
    RoundnessOutcome outcome_;
    Notes notes_;
    std::size_t read_ = 0;   ///< notes of sources_ that are in notes_
    std::string recordKey_;  ///< what the judged section depends on
};

/// All pass: pass; any out of tolerance: fail.
std::optional<Verdict> verdictOf(const std::vector<form::RoundnessResult>& results)
{
    std::optional<Verdict> all;
    for (const form::RoundnessResult& result : results) {
        if (!result.verdict) return std::nullopt;  // one tolerance for all: none has a verdict
        if (result.verdict == Verdict::Fail) return Verdict::Fail;
        if (all != Verdict::Undecided) all = result.verdict;
    }
    return all;
}

Json jsonOf(const RoundnessOutcome& outcome)
{
    Json json{{"profiles", Json::array()}};
    for (std::size_t i = 0; i < outcome.results.size(); ++i) {
        Json profile{{"path", outcome.paths[i]}};
        if (const TrajectorySection* const section = outcome.chosenSection()) profile["section"] = section->section;
        profile.update(form::toJson(outcome.results[i]));
        json["profiles"].push_back(std::move(profile));
    }
    if (outcome.superimposed) json["superimposed"] = form::toJson(*outcome.superimposed);
    return json;
}

report::Answer answerOf(const RoundnessOutcome& outcome, const Language& language)
{
    if (outcome.results.empty()) return {};
    report::Answer answer = form::answer(outcome.results.front(), language);
    if (outcome.trajectory) answer.used = outcome.trajectory->used;
    return answer;
}

report::Section summaryOf(const RoundnessOutcome& outcome, const Language& language)
{
    report::Section summary{LT_TEXT("Engine", "Result"), {}};
    const auto append = [&summary](report::Section section) {
        for (report::Block& block : section.blocks) summary.blocks.push_back(std::move(block));
    };
    for (std::size_t i = 0; i < outcome.results.size(); ++i) {
        report::Section section = roundnessSummary(outcome.results[i], language);
        auto& answer = std::get<report::Answer>(section.blocks.front());
        if (outcome.results.size() > 1)
            summary.blocks.emplace_back(report::QuantityTable{outcome.paths[i], {}});  // a heading
        if (outcome.trajectory) answer.used = outcome.trajectory->used;
        if (const TrajectorySection* const chosen = outcome.chosenSection())
            section.blocks.insert(section.blocks.begin() + 1, sectionSentence(*outcome.trajectory, *chosen));
        append(std::move(section));
    }
    if (outcome.superimposed) append(superimposeSection(*outcome.superimposed));
    return summary;
}

report::Document reportOf(const RoundnessOutcome& outcome, const Language& language)
{
    report::Document document = roundnessReport(outcome.results, outcome.sources.inputs, language);
    if (const TrajectorySection* const section = outcome.chosenSection())
        addSectionSentence(document, *outcome.trajectory, *section);
    if (outcome.superimposed) document.sections.push_back(superimposeSection(*outcome.superimposed));
    document.synthetic = outcome.sources.synthetic;
    return document;
}

/// When the profiles were measured, by their files; now for a pipe and for an item.
std::vector<std::string> measuredTimes(const std::vector<std::string>& paths)
{
    std::vector<std::string> times;
    for (const std::string& path : paths) {
        struct stat status {};
        const bool is_file = ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
        times.push_back(is_file ? io::qdasTime(status.st_mtime) : std::string());
    }
    return times;
}

std::vector<task::Input> roundnessInputs()
{
    task::Input profile =
        task::input<io::ProfileInput>(profileRole, "", LT_TEXT("Engine", "Measured profile"),
                                      LT_TEXT("Engine", "A measured profile: x,y or angle,radius in a text table."));
    profile.several = true;
    profile.is_of_part = true;
    task::Input record = recordInput("record");
    record.required = false;
    record.help = LT_TEXT("Engine", "Judge a section of this probe record in place of a profile.");
    return {std::move(profile),
            task::optionalInput<io::ProfileInput>(
                traceRole, "superimpose", LT_TEXT("Engine", "Trace to lay over"),
                LT_TEXT("Engine", "Lay the profile of this file on the one given: rotation and centre fitted.")),
            std::move(record)};
}

}  // namespace

const TrajectorySection* RoundnessOutcome::chosenSection() const
{
    return trajectory && section ? &trajectory->sections[*section] : nullptr;
}

RoundnessOutcome answerRoundness(const project::PanelState& state, form::MethodTable methods, Stores& stores,
                                 task::Sources& sources, const Progress& progress)
{
    return Judge(state, methods, stores, sources).answer(progress);
}

RoundnessOutcome answerRoundness(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                 const Progress& progress)
{
    RoundnessOutcome outcome = answerRoundness(state, form::MethodTable::Made, stores, sources, progress);
    if (!outcome.errors.empty()) throw Error(outcome.errors.front());
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const RoundnessOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.verdict = verdictOf(outcome->results);
    all.errors = outcome->errors;
    all.json = [outcome] { return jsonOf(*outcome); };
    all.answer = [outcome](const Language& language) { return answerOf(*outcome, language); };
    all.summary = [outcome](const Language& language) { return summaryOf(*outcome, language); };
    if (outcome->errors.empty()) {
        all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
        all.writers[qdasExport] = [outcome](const std::string& path, const Language&, const Progress&) {
            io::writeDfq(path, form::qdasFile(outcome->results, measuredTimes(outcome->paths)));
        };
    }
    return settled(roundnessTask(), std::move(all), outcome->understanding);
}

const task::Task& roundnessTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "roundness";
        made.title = LT_TEXT("Engine", "Roundness");
        made.summary = "Roundness of profiles: four reference circles, harmonics, uncertainty, verdict.";
        made.question = "roundness";
        made.inputs = roundnessInputs();
        made.one_of = {{profileRole, recordRole}, LT_TEXT("Engine", "Probe record or profile")};
        task::askFor<RoundnessQuestion>(made);
        made.exports = {{qdasExport, "Write the deviations as Q-DAS characteristics (FILE.dfq).",
                         LT_TEXT("Engine", "For statistical process control (Q-DAS)…"),
                         LT_TEXT("Engine", "Q-DAS (*.dfq)"), "dfq"}};
        made.run = [](const project::PanelState& state, const task::Wanted& wanted, Stores& stores,
                      task::Sources& sources, const Progress& progress) {
            const auto methods = wanted.in_full ? form::MethodTable::Made : form::MethodTable::LeftOut;
            return outcomeOf(
                std::make_shared<const RoundnessOutcome>(answerRoundness(state, methods, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::trajectory
