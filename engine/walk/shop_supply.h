// The shop as the supply of a walk.
#pragma once

#include "engine/shop/shop_file.h"
#include "engine/walk/supply.h"

namespace lathelier::walk {

inline constexpr const char* programPlace = "turning";  ///< key of the state whose job clamps the part

/// A part is held as the job clamps it that the project gives for its turning program, else as that of the shop.
/// Error shopEntryUnknown.
Supply supplyOf(const shop::StatedShop& shop);

}  // namespace lathelier::walk
