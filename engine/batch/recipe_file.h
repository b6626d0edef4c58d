// RECIPE.json:
//   {"schema": "lathelier-recipe", "schema_version": 1, "task": "compare", "program_version": "0.1",
//    "inputs": {"reference": {"path": "original.ply", "sha256": "…", "reading": {…}}},
//    "varied": ["copy"], "parameters": {…}, "reading": {…}, "shop": {"path": "shop.json", "sha256": "…"}}
// Paths are relative to the file where they can be. An input whose file names others has them as "files": [{path,
// sha256}]; a shop that is built-in is {"name": …}. What is not known is refused by its place.
#pragma once

#include <string>

#include "engine/batch/recipe.h"
#include "engine/core/input_file.h"
#include "engine/core/json.h"

namespace lathelier::batch {

inline constexpr const char* recipeSchema = "lathelier-recipe";
inline constexpr int recipeVersion = 1;

/// The object of a recipe whose file stands in `folder`; empty: the working folder.
Json toJson(const Recipe& recipe, const std::string& folder);

/// The object as results and archive keep it: without paths and the version that saved it, so that recipes of one
/// identity have one content wherever they lie.
Json contentOf(const Recipe& recipe);

/// Writes the file. Error fileNotWritable.
void writeRecipe(const std::string& path, const Recipe& recipe);

/// A recipe whose file stands in `folder`. Errors, with line and column: malformed, keyMissing, keyOutOfRange,
/// recipeMemberUnknown, recipeTooNew, recipeTaskUnknown. The files of its inputs are not opened: requireUnchanged().
Recipe readRecipe(const std::string& text, const std::string& folder, const Tasks& tasks);

struct LoadedRecipe {
    Recipe recipe;
    InputFile file;  ///< its file
};

/// The same of a file. Errors of FileBytes besides, all with the path. Throws Cancelled.
LoadedRecipe loadRecipe(const std::string& path, const Tasks& tasks, const Progress& progress = {});

}  // namespace lathelier::batch
