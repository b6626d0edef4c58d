// SHOP.json: which entries a shop uses, and its own ones: {"choice": {"lathe": "universal", …}, "lathes": […],
// "chucks": […], "tailstocks": […], "tool_sets": […], "materials": […]}. Every list is optional; what the choice does
// not name is that of the built-in shop.
#pragma once

#include <string>

#include "engine/io/file_kind.h"
#include "engine/shop/shop_library.h"

namespace lathelier::shop {

/// Key of the text of a shop in project::Project::shop.
inline constexpr const char* shopTextKey = "shop";

/// A shop as a file or the settings keep it.
struct StatedShop {
    ShopChoice choice;
    ShopLibrary own;  ///< entries of the shop itself

    /// The shop that is chosen, own entries first. Error shopEntryUnknown.
    Shop shop() const;
};

/// Errors with line and column: malformed, keyMissing, keyOutOfRange. Notes: unknownKey. Error shopEntryUnknown.
StatedShop readShop(const std::string& json, Notes& notes);

/// The text of a file that readShop() reads to the same bits.
std::string shopText(const StatedShop& shop);

struct ShopFile {
    StatedShop shop;
    io::FileFacts facts;  ///< as shopFiles() has them
    Notes notes;          ///< of the reading, with the path
};

/// Errors of readShop() and fileEmpty, with the path.
ShopFile loadShop(const io::FileToRead& file);

/// SHOP.json. facts: format "shop_json"; details "lathe", "chuck", "tailstock", "tools", "material" (keys).
const io::FileKind& shopFiles();

}  // namespace lathelier::shop
