// A recipe: a task with its question and with those inputs that all parts share. What is left open are the inputs that
// change from part to part (task::Input::is_of_part).
#pragma once

#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/value.h"
#include "engine/project/project.h"
#include "engine/task/task.h"

namespace lathelier::batch {

/// The tasks that recipes may name; they outlive whatever is made from them.
using Tasks = std::vector<const task::Task*>;

/// A file of all parts, by its content when the recipe was made.
struct RecipeFile {
    std::string path;    ///< as it can be opened; relative to the recipe in its file
    std::string sha256;  ///< lower-case hexadecimal
};

struct FixedInput {
    std::string role;               ///< "reference"
    std::vector<RecipeFile> files;  ///< the file itself, then those that it names (the stock of a set-up)
    Values reading;                 ///< reading options by key
};

/// A shop that makes what is not given.
struct RecipeShop {
    RecipeFile file;   ///< SHOP.json; empty path: the one of `name`
    std::string name;  ///< of a shop that is built-in
    bool isGiven() const { return !name.empty() || !file.path.empty(); }
};

struct Recipe {
    const task::Task* task = nullptr;  ///< never null in a recipe that was made or read
    std::string version;               ///< of the program that made it
    std::vector<FixedInput> inputs;    ///< in the order of the task
    std::vector<std::string> varied;   ///< roles that each part fills, in the order of the task; at least one
    Values parameters;                 ///< of the question, by key; one that is missing has its default
    Values reading;                    ///< reading options of the varied inputs
    RecipeShop shop;                   ///< none: nothing is made
};

/// Whether the state gives an input that changes from part to part: the command line and files alike can vary it.
bool hasVaried(const task::Task& task, const project::PanelState& state);

/// The recipe of what a state asks. Reads the files of the fixed inputs. Parameters that a window alone keeps
/// (FieldInfo::is_kept) are those of one part and are left out. Errors: recipeNothingVaries; recipeHoldsNoItem for a
/// fixed input that is an item; recipeNamesPlace for a parameter that is the path of a file or folder; those of the
/// readers. Throws Cancelled.
Recipe recipeOf(const task::Task& task, const project::PanelState& state, const Progress& progress = {});

/// Errors recipeNothingVaries, recipeOfNoPart, before anything is read.
void requireVaried(const task::Task& task, const project::PanelState& state);

/// SHA-256 of what decides on the answers: task, parameters, reading options, varied roles, shop, and the content of
/// the fixed inputs; not of paths, of the order or form of the file, or of the program's version.
std::string identityOf(const Recipe& recipe);

/// Fixed inputs and parameters as a task is asked.
project::PanelState stateOf(const Recipe& recipe);

/// Errors recipeInputChanged, recipeInputMissing (`path`, `role`). Reads the files. Throws Cancelled.
void requireUnchanged(const Recipe& recipe, const Progress& progress = {});

/// All files of the recipe: of the fixed inputs and of the shop.
std::vector<RecipeFile> filesOf(const Recipe& recipe);

}  // namespace lathelier::batch
