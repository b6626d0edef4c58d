#include "engine/shop/shop_library.h"

#include <algorithm>

#include "engine/core/units.h"
#include "engine/io/json/json_fields.h"
#include "engine/io/json/library_file.h"
#include "engine/shop/shop_codes.h"

namespace lathelier::shop {
namespace {

/// Names of the tables, as files have them and as errors name them.
struct Table {
    const char* list;
    Text name;
};
constexpr Table lathes{"lathes", LT_TEXT("Engine", "lathe")}, chucks{"chucks", LT_TEXT("Engine", "chuck")},
    tailstocks{"tailstocks", LT_TEXT("Engine", "tailstock")}, toolSets{"tool_sets", LT_TEXT("Engine", "set of tools")},
    materials{"materials", LT_TEXT("Engine", "material")};

template <class T>
void readTable(const io::JsonCursor& object, const Table& table, std::vector<ShopEntry<T>>& entries, Notes& notes)
{
    const auto list = object.member(table.list);
    if (!list) return;
    for (LibraryEntry<T>& entry : io::readLibraryList<T>(*list, infos<T>(), notes))
        entries.push_back({std::move(entry), true});
}

/// An own entry that is as the built-in one stays assumed: nobody has stated anything.
template <class T>
void unite(std::vector<ShopEntry<T>>& own, const std::vector<ShopEntry<T>>& others)
{
    for (const ShopEntry<T>& other : others) {
        const auto same =
            std::find_if(own.begin(), own.end(), [&](const ShopEntry<T>& one) { return one.key == other.key; });
        if (same == own.end())
            own.push_back(other);
        else if (same->value == other.value && same->source == other.source)
            same->is_own = other.is_own;
    }
}

template <class T>
Chosen<T> chosen(const std::vector<ShopEntry<T>>& entries, const Table& table, const std::string& key)
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const ShopEntry<T>& entry) { return entry.key == key; });
    if (found != entries.end()) {
        Chosen<T> made{found->key, found->value, found->source, !found->is_own};
        if (made.value.name.empty()) made.value.name = found->key;
        return made;
    }
    std::string known;
    for (const ShopEntry<T>& entry : entries) known += (known.empty() ? "" : ", ") + entry.key;
    throw Error(errors::shopEntryUnknown, {{"table", table.name}, {"key", key}, {"known", known}});
}

}  // namespace

const std::vector<Field<ShopChoice>>& fieldsOf(const ShopChoice*)
{
    using C = ShopChoice;
    const Text help = LT_TEXT("Engine", "By its key in the tables of the shop.");
    static const auto all = described<C>(
        field("lathe", &C::lathe, Label{LT_TEXT("Engine", "Lathe"), help}),
        field("chuck", &C::chuck, Label{LT_TEXT("Engine", "Chuck"), help}),
        field("tailstock", &C::tailstock,
              Label{LT_TEXT("Engine", "Tailstock"), LT_TEXT("Engine", "By its key; empty: the shop has none.")}),
        field("tools", &C::tools, Label{LT_TEXT("Engine", "Set of tools"), help}),
        field("material", &C::material, Label{LT_TEXT("Engine", "Material"), help}),
        field("post", &C::post,
              Label{LT_TEXT("Engine", "Control"), LT_TEXT("Engine", "A post by its name; empty: that of the lathe.")}));
    return all;
}

bool isTable(const std::string& key)
{
    const Table tables[] = {lathes, chucks, tailstocks, toolSets, materials};
    return std::any_of(std::begin(tables), std::end(tables), [&](const Table& table) { return key == table.list; });
}

ShopLibrary readLibrary(const io::JsonCursor& object, Notes& notes)
{
    ShopLibrary library;
    readTable(object, lathes, library.lathes, notes);
    readTable(object, chucks, library.chucks, notes);
    readTable(object, tailstocks, library.tailstocks, notes);
    readTable(object, toolSets, library.tool_sets, notes);
    readTable(object, materials, library.materials, notes);
    return library;
}

const ShopLibrary& shopLibrary()
{
    static const ShopLibrary library = [] {
        const io::JsonDocument document{builtInShop().front().text};
        Notes notes;
        ShopLibrary made = readLibrary(document.root(), notes);
        const auto buildIn = [](auto& entries) {
            for (auto& entry : entries) entry.is_own = false;
        };
        buildIn(made.lathes);
        buildIn(made.chucks);
        buildIn(made.tailstocks);
        buildIn(made.tool_sets);
        buildIn(made.materials);
        return made;
    }();
    return library;
}

ShopLibrary united(ShopLibrary own, const ShopLibrary& library)
{
    unite(own.lathes, library.lathes);
    unite(own.chucks, library.chucks);
    unite(own.tailstocks, library.tailstocks);
    unite(own.tool_sets, library.tool_sets);
    unite(own.materials, library.materials);
    return own;
}

Shop shopOf(const ShopChoice& choice, const ShopLibrary& library)
{
    Shop shop;
    shop.lathe = chosen(library.lathes, lathes, choice.lathe);
    shop.chuck = chosen(library.chucks, chucks, choice.chuck);
    if (!choice.tailstock.empty()) shop.tailstock = chosen(library.tailstocks, tailstocks, choice.tailstock);
    shop.tools = chosen(library.tool_sets, toolSets, choice.tools);
    shop.material = chosen(library.materials, materials, choice.material);
    if (!choice.post.empty()) shop.lathe.value.post = choice.post;
    return shop;
}

}  // namespace lathelier::shop
