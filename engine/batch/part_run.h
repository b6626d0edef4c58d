// One part: its content, whether it is known, its evaluation.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/archive/evaluation.h"
#include "engine/batch/part_list.h"
#include "engine/batch/recipe.h"
#include "engine/task/reply.h"

namespace lathelier::batch {

/// Makes what a recipe with a shop leaves open; none: nothing is made.
using CompleteFrom = std::function<task::Completion(const Recipe& recipe, const Progress& progress)>;

/// What all parts share. Thread-safe.
class PartRun {
public:
    PartRun(const Recipe& recipe, const CompleteFrom& complete, const Progress& progress);

    /// The evaluation before it is computed: task, recipe, version, and inputs by their digests. Files that belong to
    /// one record are inputs of the same role. Errors of the files (`path`). Throws Cancelled.
    archive::Evaluation begin(const Part& part) const;

    struct Answer {
        archive::Evaluation evaluation;  ///< with inputs that the reader opened besides
        std::optional<Error> error;      ///< none: answered
        bool is_lasting = false;         ///< the same content will give it again
        std::string report;              ///< HTML, where asked for and possible
    };

    /// Computes it. `error` for whatever keeps the part from an answer. Errors that end the run: recipeInputChanged.
    /// Throws Cancelled.
    Answer answer(const Part& part, archive::Evaluation begun, bool with_report);

private:
    bool isOfRecipe(const std::string& path) const;
    void takeSources(const Part& part, const task::Reply& reply, Answer& answer) const;

    const Recipe& recipe_;
    std::string identity_;
    project::PanelState fixed_;
    std::vector<RecipeFile> files_;
    task::Completion complete_;
    Progress progress_;
    Stores stores_;
};

}  // namespace lathelier::batch
