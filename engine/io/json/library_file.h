// Files of libraries: {"about", LIST: [{"key", fields of the struct, "source"}…]}.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "engine/core/library.h"
#include "engine/io/json/json_fields.h"

namespace lathelier::io {

inline constexpr std::size_t mostLibraryEntries = 1000;

/// Entries of a list, whose fields are `described`. Errors as readLibrary().
template <class T>
std::vector<LibraryEntry<T>> readLibraryList(const JsonCursor& list, const std::vector<FieldInfo>& described,
                                             Notes& notes)
{
    std::vector<LibraryEntry<T>> library;
    list.items(mostLibraryEntries, [&](const JsonCursor& item) {
        const Text text = LT_TEXT("Engine", "a text");
        library.push_back({item.at("key", text).string(),
                           fromValues<T>(valuesOf(item, described, notes, {"key", "source"})),
                           item.at("source", text).string()});
    });
    return library;
}

/// `required`: fields that every entry states, besides those that are required anyway. Errors with line and column:
/// malformed, keyMissing, keyOutOfRange, valueStatedTwice.
template <class T>
std::vector<LibraryEntry<T>> readLibrary(const std::string& json, const char* list,
                                         const std::vector<std::string>& required = {})
{
    const JsonDocument document{json};
    std::vector<FieldInfo> described = infos<T>();
    for (FieldInfo& info : described)
        if (std::find(required.begin(), required.end(), info.key) != required.end()) {
            info.required = true;
            info.optional = false;
        }
    Notes notes;
    return readLibraryList<T>(document.root().at(list, LT_TEXT("Engine", "a list")), described, notes);
}

}  // namespace lathelier::io
