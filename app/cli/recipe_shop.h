// The shop of a recipe, for the verbs that ask recipes.
#pragma once

#include "engine/batch/recipe.h"
#include "engine/task/reply.h"

namespace lathelier::cli {

/// What a recipe's shop makes, as the verb of its task does.
task::Completion completedByRecipe(const batch::Recipe& recipe, const Progress& progress);

}  // namespace lathelier::cli
