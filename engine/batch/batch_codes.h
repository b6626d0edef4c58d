// Errors and notes of recipes and of runs over many parts.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode recipeInputChanged{
    "recipe_input_changed", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The recipe was made with another content of {role}: SHA-256 is {found}, expected {expected}. Save the "
            "recipe anew, or bring the file back.")};

inline constexpr ErrorCode recipeInputMissing{
    "recipe_input_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The {role} of the recipe is not there; expected a file with the SHA-256 {expected}.")};

inline constexpr ErrorCode recipeTaskUnknown{"recipe_task_unknown", ErrorKind::InputRejected,
                                             LT_TEXT("Engine", "This program has no task “{found}”; it has {known}.")};

inline constexpr ErrorCode recipeMemberUnknown{"recipe_member_unknown", ErrorKind::InputRejected,
                                               LT_TEXT("Engine", "“{key}” is not known here; expected {expected}.")};

inline constexpr ErrorCode recipeTooNew{
    "recipe_too_new", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The recipe has version {found}; this program reads up to version {maximum}.")};

inline constexpr ErrorCode recipeNothingVaries{
    "recipe_nothing_varies", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "{task}: nothing that was given changes from part to part; a recipe needs one of {roles}.")};

inline constexpr ErrorCode recipeOfNoPart{
    "recipe_of_no_part", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "{task} has no input that changes from part to part: there is no recipe of it.")};

inline constexpr ErrorCode recipeHoldsNoItem{
    "recipe_holds_no_item", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "A recipe holds files: {role} is “{item}” of the project. Save it as a file, and choose that.")};

inline constexpr ErrorCode recipeNamesPlace{
    "recipe_names_place", ErrorKind::WrongUsage,
    LT_TEXT("Engine",
            "A recipe cannot hold {parameter}: {found} is a file or folder, whose content is not that of the recipe.")};

inline constexpr ErrorCode batchNeedsGroups{
    "batch_needs_groups", ErrorKind::WrongUsage,
    LT_TEXT("Engine",
            "Each part of this recipe has {roles}: state a list with one part a line, {\"inputs\": {role: file}}.")};

inline constexpr ErrorCode batchOtherRecipe{
    "batch_other_recipe", ErrorKind::WrongUsage,
    LT_TEXT("Engine",
            "The file holds the results of the recipe {found}; this one is {expected}. One folder is for one recipe.")};

inline constexpr ErrorCode batchUnderWay{"batch_under_way", ErrorKind::OutputFailed,
                                         LT_TEXT("Engine", "Another run is writing these results.")};

inline constexpr ErrorCode batchNotRemembered{
    "batch_not_remembered", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "The folder remembers no earlier run: state the recipe and the files.")};

inline constexpr ErrorCode batchPartsFailed{
    "batch_parts_failed", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Parts without an answer: {failed} of {parts}; {file} says why.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode partRepeated{"part_repeated", Severity::Info,
                                       LT_TEXT("Engine", "{path} has the content of {other}: it was evaluated once.")};

inline constexpr NoteCode partsRepeated{"parts_repeated", Severity::Info,
                                        LT_TEXT("Engine", "Further parts with the content of another: {count}.")};

}  // namespace notes

}  // namespace lathelier
