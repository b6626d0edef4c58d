// The option --shop of verbs whose task takes a job, a set-up or a spindle: what is not given is made from the shop.
#pragma once

#include <string>

#include "app/cli/verb.h"
#include "engine/task/reply.h"

namespace lathelier::cli {

inline constexpr const char* shopKey = "shop";
inline constexpr const char* postKey = "post";  ///< of a control: the one that is typed rules over that of the shop

Option shopOption();

/// The value of the option, taken out of the parameters of the task; empty: no shop.
std::string takeShopOption(Values& parameters);

/// Fills what the request leaves open from the shop: the path of SHOP.json, or shop::builtInName. The part is that of
/// the task's shaft. `task` and `progress` outlive it. Errors of the readers of shop and part; those of
/// shop::fillFromShop(); shopNeedsPart.
task::Completion completedFromShop(const task::Task& task, const std::string& shop, const Request& request,
                                   const Progress& progress);

}  // namespace lathelier::cli
