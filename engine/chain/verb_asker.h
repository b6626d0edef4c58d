// How the chain asks for its steps: by the verbs of the command line, whoever holds their table. Window and command
// line hand the same function in, so that both run the same steps.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/report/document.h"

namespace lathelier::chain {

/// One question to a verb.
struct VerbQuestion {
    std::string verb;                            ///< its name
    std::vector<std::string> operands;           ///< paths
    Values given;                                ///< parameters that differ from their defaults; others are left out
    std::map<std::string, std::string> outputs;  ///< option of the verb → path of the file to write
};

/// What became of it.
struct VerbReply {
    std::shared_ptr<const Json> result;     ///< the whole object, never null
    std::vector<InputFile> inputs;          ///< that were read
    Values parameters;                      ///< all of them
    Notes notes;                            ///< of the answer
    std::vector<Error> errors;              ///< empty: answered
    std::vector<report::Section> sections;  ///< of its report; empty where it refused
};

/// Blocks; safe from any thread. Refusals are in the reply. Throws Cancelled.
using AskVerb = std::function<VerbReply(const VerbQuestion& question, const Progress& progress)>;

}  // namespace lathelier::chain
