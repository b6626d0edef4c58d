// Steps of a chain: tasks run in sequence with their files in one folder, recorded in a dossier.
//
// A step whose request, files and program version equal those of an earlier run, with unchanged files on the disk, is
// reused. A dry run executes and writes nothing; it reports which steps would be run.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/chain/dossier.h"
#include "engine/core/progress.h"
#include "engine/task/task.h"

namespace lathelier::chain {

enum class RunMode : std::uint8_t {
    Everything,  ///< run every step
    OutOfDate,   ///< reuse unchanged steps
    DryRun       ///< run and write nothing
};

/// Request of a step to a task. Files within the folder of the chain have relative names.
struct StepRequest {
    std::string id;  ///< of the step; its result is ID.json
    const task::Task* task = nullptr;
    std::vector<std::string> operands;                         ///< as paths
    Values given;                                              ///< parameters that differ from their defaults
    std::map<std::string, std::string> outputs;                ///< task::Export::option → name within the folder
    std::map<std::string, std::string> outputs_if_possible{};  ///< the same; omitted if the task refuses them
};

/// Result of a step that is not a task.
struct MadeStep {
    std::shared_ptr<const Json> result;  ///< never null
    Notes notes;
    std::vector<report::Section> sections;
    std::optional<Verdict> verdict = {};  ///< none: nothing to judge
};

class StepRunner {
public:
    /// Creates the folder, except in a dry run. `earlier`: of the last run in this folder; null: none. Error
    /// fileNotWritable.
    StepRunner(std::string folder, RunMode mode, std::shared_ptr<const Dossier> earlier);

    std::string path(const std::string& name) const;  ///< of a file within the folder

    /// Runs the task, writes its result and files, records the step. Returns the result; an empty object if there is
    /// none. After a failed step nothing is run. Throws Cancelled.
    Json run(const StepRequest& step, const Progress& progress);

    /// The same for a step that is not a task, from files within the folder.
    Json make(const std::string& id, const std::vector<std::string>& inputs, const std::function<MadeStep()>& make,
              const Progress& progress);

    /// Adds an input of the next step besides those of its task.
    void addInput(const InputFile& file) { furtherInputs_.push_back(named(file)); }
    void addInput(const std::string& name) { furtherInputs_.push_back(madeFile(name, {})); }  ///< within the folder
    /// Writes a file of the chain for the next step.
    void write(const std::string& name, const std::string& text);

    void recordMissing(const std::string& id, Text what);           ///< records a step with a missing input
    void recordFailure(const std::string& id, const Error& error);  ///< records a step whose preparation failed
    void keepEarlierSteps();  ///< after cancellation: keeps the records of the earlier run for steps not reached
    void addNote(Note note);  ///< adds a note to the last step, unless it was reused

    /// Why the last step omitted its outputs_if_possible; none: not omitted.
    const std::optional<Error>& refusal() const { return refusal_; }
    bool hasFailed() const { return failed_; }
    bool isDone(const std::string& id) const;
    bool canRead(const std::string& name) const;  ///< the file within the folder exists and is up to date
    Dossier& dossier() { return dossier_; }

private:
    InputFile named(InputFile file) const;
    InputFile madeFile(const std::string& name, const Progress& progress);
    const std::string& digest(const std::string& path, const Progress& progress);
    const ChainStep* unchanged(const ChainStep& step, const Progress& progress);
    Json takeOver(const ChainStep& step, const Progress& progress);
    Json dryRun(ChainStep step, const std::vector<std::string>& names);
    void finish(ChainStep step, const Json& result);
    bool isStale(const std::string& path) const { return stale_.count(path) > 0; }
    std::string requestOf(const StepRequest& step) const;
    std::vector<std::string> namesOf(const StepRequest& step) const;

    std::string folder_;
    RunMode mode_;
    std::shared_ptr<const Dossier> earlier_;
    Dossier dossier_;
    std::vector<InputFile> furtherInputs_;
    std::vector<std::string> furtherOutputs_;
    std::map<std::string, std::string> digests_;  ///< by path; empty: missing
    std::set<std::string> stale_;                 ///< names within the folder that a run would rewrite
    std::optional<Error> refusal_;
    bool failed_ = false;
    bool takenOver_ = false;  ///< the last step was reused
};

}  // namespace lathelier::chain
