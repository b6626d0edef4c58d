// The task shop: the tables of a shop with what is chosen of them. The verb.
#pragma once

#include <memory>

#include "engine/shop/shop_file.h"
#include "engine/task/task.h"

namespace lathelier::shop {

inline constexpr const char* shopRole = "shop";
inline constexpr const char* shopExport = "out";  ///< the chosen entries as SHOP.json, to be edited

struct ShopOutcome : task::Answered {
    StatedShop stated;    ///< the choice, and the own entries of the file
    ShopLibrary library;  ///< own entries and those that are built in
    Shop shop;            ///< what is chosen
};

/// The choice of the file, with what the question chooses otherwise. Errors of loadShop(); shopEntryUnknown.
ShopOutcome answerShop(const project::PanelState& state, Stores& stores, task::Sources& sources,
                       const Progress& progress);

/// The chosen entries as a shop's own ones, the others left out.
StatedShop chosenOnly(const ShopOutcome& outcome);

const task::Task& shopTask();

}  // namespace lathelier::shop
