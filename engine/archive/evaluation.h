// One evaluation as a batch writes it and the archive keeps it: what was asked, of which content, by which version, and
// what came out. A value; as a line of JSON Lines it is one object on one line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/input_file.h"
#include "engine/core/json.h"
#include "engine/task/characteristic.h"

namespace lathelier::archive {

struct EvaluatedInput {
    std::string role;  ///< of the task, "copy"
    InputFile file;    ///< path as it was opened, bytes, SHA-256
};

struct Evaluation {
    std::string task;                                   ///< key of the task, "compare"
    std::string recipe_sha256;                          ///< identity of the recipe (batch/recipe.h)
    std::string version;                                ///< of the program
    std::vector<EvaluatedInput> inputs;                 ///< those that change from part to part, in the order of roles
    int exit_code = 0;                                  ///< of the verb: 0 answered, 3 rejected, 4 no answer
    std::optional<Verdict> verdict;                     ///< none: nothing to judge
    std::vector<task::Characteristic> characteristics;  ///< empty where an error ended the run
    std::string result = "null";                        ///< the whole object of the verb as JSON on one line

    /// What makes two evaluations the same: SHA-256 of task, recipe, version, roles and content of the inputs; not of
    /// paths or of what came out.
    std::string key() const;
};

/// The keys in the order of the struct, `key` first. One line: result.dump() without an end of line.
Json toJson(const Evaluation& evaluation);

/// The reverse, of one line. Errors: malformed (line 1 and column, or the missing member), evaluationAltered where
/// `key` is not that of the content.
Evaluation evaluationFrom(std::string_view line);

/// What is equal wherever and in whatever order it was computed: as toJson(), with file names in place of paths, in the
/// result too.
Json canonicalOf(const Evaluation& evaluation);

}  // namespace lathelier::archive
