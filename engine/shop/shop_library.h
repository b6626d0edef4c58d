// Tables of a shop, and the shop that is chosen from them by name. Built in: resources/library/shop.json, whose entries
// are examples; a shop's own entries take the place of those of the same key.
#pragma once

#include <string>
#include <vector>

#include "engine/core/built_in_text.h"
#include "engine/core/error.h"
#include "engine/core/library.h"
#include "engine/shop/shop.h"

namespace lathelier::io {
class JsonCursor;
}

namespace lathelier::shop {

/// An entry with where it belongs: the shop's own or built in.
template <class T>
struct ShopEntry : LibraryEntry<T> {
    bool is_own = false;
};

struct ShopLibrary {
    std::vector<ShopEntry<Lathe>> lathes;
    std::vector<ShopEntry<Chuck>> chucks;
    std::vector<ShopEntry<Tailstock>> tailstocks;
    std::vector<ShopEntry<ToolSet>> tool_sets;
    std::vector<ShopEntry<BarMaterial>> materials;
};

/// Keys of the entries; an empty tailstock: the shop has none.
struct ShopChoice {
    std::string lathe = "universal", chuck = "papers", tailstock = "live_centre", tools = "turret", material = "c45";
    std::string post;  ///< of the control; empty: that of the lathe
    friend bool operator==(const ShopChoice&, const ShopChoice&) = default;
};

const std::vector<Field<ShopChoice>>& fieldsOf(const ShopChoice*);

inline constexpr const char* builtInName = "built-in";  ///< of the shop that is built in, in place of a file

const std::vector<BuiltInText>& builtInShop();  ///< resources/library/shop.json

/// The library that is built in. Thread-safe; lives as long as the program.
const ShopLibrary& shopLibrary();

bool isTable(const std::string& key);  ///< key of one of the lists that readLibrary() reads

/// Entries of an object with any of the lists lathes, chucks, tailstocks, tool_sets, materials, as own ones. Errors
/// with line and column: malformed, keyMissing, keyOutOfRange, valueStatedTwice.
ShopLibrary readLibrary(const io::JsonCursor& object, Notes& notes);

/// `own` first, then those of `library` whose keys it does not have. An own entry that equals that of the library is
/// not an own one.
ShopLibrary united(ShopLibrary own, const ShopLibrary& library);

/// Error shopEntryUnknown (table, key, known ones).
Shop shopOf(const ShopChoice& choice, const ShopLibrary& library = shopLibrary());

}  // namespace lathelier::shop
