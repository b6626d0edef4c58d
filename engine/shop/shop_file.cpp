#include "engine/shop/shop_file.h"

#include <nlohmann/json.hpp>

#include "engine/io/io_codes.h"
#include "engine/io/json/json_fields.h"
#include "engine/io/json/json_head.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::shop {
namespace {

constexpr const char* choiceKey = "choice";

io::Likeness likeShop(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    if (io::hasKey(keys, "command")) return io::Likeness::No;
    if (io::hasKey(keys, choiceKey)) return io::Likeness::Certain;
    return io::hasKey(keys, "lathes") || io::hasKey(keys, "chucks") || io::hasKey(keys, "tool_sets")
               ? io::Likeness::Likely
               : io::Likeness::No;
}

template <class T>
void addTable(Json& root, const char* list, const std::vector<ShopEntry<T>>& entries)
{
    if (entries.empty()) return;
    Json& table = root[list] = Json::array();
    for (const ShopEntry<T>& entry : entries) {
        Json item = io::objectOf(infos<T>(), toValues(entry.value));
        item["key"] = entry.key;
        item["source"] = entry.source;
        table.push_back(std::move(item));
    }
}

}  // namespace

Shop StatedShop::shop() const
{
    return shopOf(choice, united(own, shopLibrary()));
}

StatedShop readShop(const std::string& json, Notes& notes)
{
    const io::JsonDocument document{json};
    const io::JsonCursor root = document.root();
    const Text expected = LT_TEXT("Engine", "an object with a choice or tables of a shop");
    if (!root.isObject()) root.reject(expected);
    StatedShop shop;
    bool is_shop = false;
    root.members(io::mostJsonMembers, [&](const std::string& key, const io::JsonCursor& value) {
        const bool is_known = key == choiceKey || isTable(key);
        is_shop = is_shop || is_known;
        if (key == choiceKey) shop.choice = io::readFields<ShopChoice>(value, notes);
        const io::JsonPlace place = value.place();
        if (!is_known)
            notes.push_back({notes::unknownKey, {{"key", key}, {"line", place.line}, {"column", place.column}}});
    });
    if (!is_shop) root.reject(expected);
    shop.own = readLibrary(root, notes);
    shop.shop();  // throws for names that no table has
    return shop;
}

std::string shopText(const StatedShop& shop)
{
    Json root = Json::object();
    root[choiceKey] = io::objectOf(infos<ShopChoice>(), toValues(shop.choice));
    addTable(root, "lathes", shop.own.lathes);
    addTable(root, "chucks", shop.own.chucks);
    addTable(root, "tailstocks", shop.own.tailstocks);
    addTable(root, "tool_sets", shop.own.tool_sets);
    addTable(root, "materials", shop.own.materials);
    return root.dump(2) + "\n";
}

ShopFile loadShop(const io::FileToRead& file)
{
    ShopFile loaded;
    try {
        const io::DecodedText text = io::decodeText(file.bytes, io::Encoding::Auto, file.progress);
        if (io::trimmed(text.view()).empty()) throw Error(errors::fileEmpty, {});
        loaded.shop = readShop(std::string(text.view()), loaded.notes);
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    for (Note& note : loaded.notes) set(note.values, "path", file.path);
    loaded.facts.path = file.path;
    loaded.facts.format = "shop_json";
    for (const auto& [key, value] : toValues(loaded.shop.choice)) set(loaded.facts.details, key, value);
    return loaded;
}

const io::FileKind& shopFiles()
{
    static const io::FileKind kind{
        "shop", LT_TEXT("Engine", "Shops"), "*.json", {}, {}, likeShop, [](const io::FileToRead& file, Notes& notes) {
            ShopFile loaded = loadShop(file);
            notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
            return std::move(loaded.facts);
        }};
    return kind;
}

}  // namespace lathelier::shop
