// Steps of a chain: verbs asked one after the other, their files in one folder, all of it recorded in a dossier.
//
// A step whose question, files and program version are those of an earlier run, and whose files lie on the disk as they
// were made, is taken over from there. A look asks and writes nothing: it says which steps would be run.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/chain/dossier.h"
#include "engine/chain/verb_asker.h"

namespace lathelier::chain {

enum class RunMode : std::uint8_t {
    Everything,  ///< every step is asked
    OutOfDate,   ///< steps that are as they were are taken over
    Look         ///< nothing is asked, nothing is written
};

/// What one step asks of a verb. Files within the folder of the chain are named without it.
struct StepRequest {
    std::string id;                                            ///< of the step; its result is ID.json
    std::string verb;                                          ///< name
    std::vector<std::string> operands;                         ///< of the verb, as paths
    Values given;                                              ///< parameters that differ from their defaults
    std::map<std::string, std::string> outputs;                ///< option of the verb → name within the folder
    std::map<std::string, std::string> outputs_if_possible{};  ///< the same; left out where the verb refuses them
};

/// The result of a step that is no verb.
struct MadeStep {
    std::shared_ptr<const Json> result;     ///< never null
    Notes notes;                            ///< of the step
    std::vector<report::Section> sections;  ///< of its report
};

class StepRunner {
public:
    /// Makes the folder, but for a look. `earlier`: of the last run in this folder; null: none. Error fileNotWritable.
    StepRunner(std::string folder, AskVerb ask, RunMode mode, std::shared_ptr<const Dossier> earlier);

    std::string path(const std::string& name) const;  ///< of a file within the folder

    /// Asks the verb, writes its result and its files, records the step. Gives its result; an object without members
    /// where there is none. After a step that failed nothing is asked any more. Throws Cancelled.
    Json run(const StepRequest& step, const Progress& progress);

    /// The same for a step that is no verb, from files within the folder.
    Json make(const std::string& id, const std::vector<std::string>& inputs, const std::function<MadeStep()>& make,
              const Progress& progress);

    /// Files that the next step takes besides those of its verb: what prepared it.
    void alsoTakes(const InputFile& file) { further_inputs_.push_back(named(file)); }
    void alsoTakes(const std::string& name) { further_inputs_.push_back(madeFile(name, {})); }  ///< within the folder
    /// Writes a file of the chain for the next step.
    void write(const std::string& name, const std::string& text);

    void miss(const std::string& id, Text what);           ///< records a step that lacks an input
    void fail(const std::string& id, const Error& error);  ///< records a step whose preparation was refused
    void keepRest();         ///< after a stop: steps that were not come to stay as the earlier run left them
    void remark(Note note);  ///< of the last step, unless it was taken over

    /// Why the last step went without its outputs_if_possible; none: it did not.
    const std::optional<Error>& refusal() const { return refusal_; }
    bool hasFailed() const { return failed_; }
    bool isDone(const std::string& id) const;
    bool canRead(const std::string& name) const;  ///< the file within the folder is there and up to date
    Dossier& dossier() { return dossier_; }

private:
    InputFile named(InputFile file) const;
    InputFile madeFile(const std::string& name, const Progress& progress);
    const std::string& digest(const std::string& path, const Progress& progress);
    const ChainStep* unchanged(const ChainStep& step, const Progress& progress);
    Json takeOver(const ChainStep& step, const Progress& progress);
    Json onlyLook(ChainStep step, const std::vector<std::string>& names);
    void finish(ChainStep step, const Json& result);
    bool isStale(const std::string& path) const { return stale_.count(path) > 0; }
    std::string requestOf(const StepRequest& step) const;
    std::vector<std::string> namesOf(const StepRequest& step) const;

    std::string folder_;
    AskVerb ask_;
    RunMode mode_;
    std::shared_ptr<const Dossier> earlier_;
    Dossier dossier_;
    std::vector<InputFile> further_inputs_;
    std::vector<std::string> further_outputs_;
    std::map<std::string, std::string> digests_;  ///< by path; empty: not there
    std::set<std::string> stale_;                 ///< names within the folder that a run would make anew
    std::optional<Error> refusal_;
    bool failed_ = false;
    bool taken_over_ = false;  ///< the last step
};

}  // namespace lathelier::chain
