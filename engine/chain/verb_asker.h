// Interface by which the chain runs verbs of the command line. Window and command line pass in the same function, so
// that both run the same steps.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/report/document.h"

namespace lathelier::chain {

/// Arguments of a verb.
struct VerbQuestion {
    std::string verb;  ///< its name
    std::vector<std::string> operands;
    Values given;                                ///< parameters that differ from their defaults
    std::map<std::string, std::string> outputs;  ///< option of the verb → path of the file to write
};

/// Result of a verb.
struct VerbReply {
    std::shared_ptr<const Json> result;  ///< the whole object, never null
    std::vector<InputFile> inputs;
    Values parameters;
    Notes notes;
    std::vector<Error> errors;              ///< empty: successful
    std::optional<Verdict> verdict;         ///< of the answer itself; none: nothing to judge
    std::vector<report::Section> sections;  ///< of its report; empty on errors
};

/// Blocks; safe from any thread. Errors are in the reply. Throws Cancelled.
using AskVerb = std::function<VerbReply(const VerbQuestion& question, const Progress& progress)>;

}  // namespace lathelier::chain
