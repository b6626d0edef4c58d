// A shop as an input of a task (task/inputs.h), and by its name.
#pragma once

#include "engine/shop/shop_file.h"
#include "engine/task/inputs.h"

namespace lathelier::shop {

struct ShopInput {
    using File = ShopFile;
    using Value = Shop;
    static constexpr const char* item = "";

    static File read(const io::FileToRead& file) { return loadShop(file); }
    static Value valueOf(const File& file) { return file.shop.shop(); }
    static io::FileKinds kinds() { return {&shopFiles()}; }
};

/// The shop of this SHOP.json, or the built-in one by its name. Errors of loadShop(). Throws Cancelled.
inline Shop takeShop(const std::string& stated, Stores& stores, const Progress& progress, task::Sources& sources)
{
    if (stated == builtInName) return shopOf({});
    project::PanelState state;
    state.inputs["shop"].path = stated;
    return *task::take<ShopInput>(state, "shop", stores, progress, sources);
}

}  // namespace lathelier::shop
