// JSON Lines as a batch writes them: one evaluation a line, and lines with the recipes they follow,
//     {"recipe": {…}, "sha256": "…"}
// Blank lines do not count. A last line without its end was cut while it was written.
#pragma once

#include <string_view>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/evaluation.h"
#include "engine/core/progress.h"

namespace lathelier::archive {

struct ResultLines {
    std::vector<Evaluation> evaluations;
    std::vector<ArchivedRecipe> recipes;
};

/// Errors, each with `line` and where there is one `column`: those of evaluationFrom(), lineTorn.
ResultLines readResultLines(std::string_view text, const Progress& progress = {});

}  // namespace lathelier::archive
