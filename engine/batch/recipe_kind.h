// RECIPE.json as a kind of file: inspect says what it asks and what all its parts share.
#pragma once

#include "engine/batch/recipe.h"
#include "engine/io/file_kind.h"

namespace lathelier::batch {

/// Recipes of these tasks, which outlive the kind. facts: format "recipe"; details "schema_version", "program_version",
/// "task", "recipe_sha256" (identityOf()), "varied" (`role`), "fixed_inputs" (`role`, `path`, `sha256`; one row for
/// each file), and with a shop "shop" (`name`, or `path` and `sha256`). Digests are those that the recipe states: the
/// files are not opened. Errors of loadRecipe().
io::FileKind recipeFiles(const Tasks& tasks);

}  // namespace lathelier::batch
