// Inputs of a task that nobody gave, from the shop: jobs, set-ups, machines, and the control of the lathe.
//
// - job: from lathe, chuck, tools and material, and the tailstock where it holds the part; for the part.
// - set-up: from chuck, tools and material, and the tailstock where it holds; for the job of the part, or for a stock
//   that is given, with the program's zero at its free end.
// - spindle: from the chuck. Field `post`: from the lathe.
//
// Free is an input that is not given and in whose place nothing else is: another of Task::one_of, tools of the form of
// a job (cam::hasTools), another way to hold the work (the field "hold"). A spindle is not free where a set-up states
// the chuck, nor where it says nothing: Task::only_with, no shaft.
#pragma once

#include "engine/core/error.h"
#include "engine/project/project.h"
#include "engine/shop/shop.h"
#include "engine/task/task.h"

namespace lathelier::shop {

// Names of the items that are made.
inline constexpr const char* jobName = "shop job";
inline constexpr const char* setupName = "shop set-up";
inline constexpr const char* spindleName = "shop spindle";

/// Whether the task has an input that a shop makes.
bool takesShop(const task::Task& task);

/// Whether it has a free input that is made for a part: a job or a set-up.
bool wantsPart(const project::PanelState& state, const task::Task& task);

/// Fills the free inputs with items (state.inputs, state.items) and the field `post` where it is not given. `part`: as
/// drawn, of a task with a given stock this stock; nullptr: jobs and set-ups are not filled. A set-up brings its bar
/// unless the task has a stock, or a program that brings its own. Errors: those of jobOf() (shop_job.h). Notes: ofShop,
/// once for each used entry of the built-in library that `notes` does not name yet.
/// `job`: given for the part elsewhere; the set-up is that of this job. nullptr: that of the shop's.
void fillFromShop(project::PanelState& state, const task::Task& task, const Shop& shop, const Shaft* part, Notes& notes,
                  const cam::Job* job = nullptr);

}  // namespace lathelier::shop
