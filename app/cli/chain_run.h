// Steps of a chain: verbs asked one after the other, their files in one folder, all of it recorded in a dossier.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/verb_answer.h"
#include "engine/chain/dossier.h"

namespace lathelier::cli {

/// What one step asks of a verb. Paths within the folder of the chain are made by ChainRun::path().
struct StepRequest {
    std::string id;                              ///< of the step; its result is ID.json
    std::string verb;                            ///< name
    std::vector<std::string> operands;           ///< of the verb
    Values given;                                ///< parameters that differ from their defaults
    std::map<std::string, std::string> outputs;  ///< option of the verb → name of the file within the folder
    std::map<std::string, std::string> outputs_if_possible = {};  ///< the same; left out where the verb refuses them
};

class ChainRun {
public:
    /// Makes the folder. Error fileNotWritable.
    explicit ChainRun(std::string folder);

    /// Of a file within the folder.
    std::string path(const std::string& name) const;

    /// Asks the verb, writes its result and its files, records the step. Returns its result. After a step that failed
    /// nothing is asked any more: the step is recorded as not reached, and the result is empty. Throws Cancelled.
    Json run(const StepRequest& step, const Progress& progress);

    /// Files that the next step takes and makes besides those of its verb: what prepared it.
    void alsoTakes(const InputFile& file) { further_inputs_.push_back(file); }
    /// Writes a file of the chain for the next step.
    void write(const std::string& name, const std::string& text);

    /// Records a step that is no verb: its result is written as ID.json.
    void record(const std::string& id, const std::vector<std::string>& inputs, const Json& result, Notes notes,
                std::vector<report::Section> report);

    /// Records a step that lacks an input.
    void miss(const std::string& id, Text what);

    /// A note of the last step.
    void remark(Note note);

    /// Why the last step went without its outputs_if_possible; none: it did not.
    const std::optional<Error>& refusal() const { return refusal_; }

    bool hasFailed() const { return failed_; }
    bool isDone(const std::string& id) const;
    chain::Dossier& dossier() { return dossier_; }
    /// Of the step that failed.
    const std::optional<Error>& error() const { return error_; }
    /// Of all steps that were asked, under their own headings.
    std::vector<report::Section> sections() const { return sections_; }

    /// The file as the dossier names it.
    InputFile named(InputFile file) const;

private:
    InputFile madeFile(const std::string& name) const;
    void addReport(const Answer& answer);

    std::string folder_;
    chain::Dossier dossier_;
    std::vector<InputFile> further_inputs_;
    std::vector<std::string> further_outputs_;
    std::vector<report::Section> sections_;
    std::optional<Error> error_, refusal_;
    bool failed_ = false;
};

}  // namespace lathelier::cli
