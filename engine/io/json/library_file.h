// Files of libraries: {"about", LIST: [{"key", fields of the struct, "source"}…]}.
#pragma once

#include <string>
#include <vector>

#include "engine/core/library.h"
#include "engine/io/json/json_fields.h"

namespace lathelier::io {

inline constexpr std::size_t mostLibraryEntries = 1000;

/// Errors with line and column: malformed, keyMissing, keyOutOfRange.
template <class T>
std::vector<LibraryEntry<T>> readLibrary(const std::string& json, const char* list)
{
    const JsonDocument document{json};
    std::vector<LibraryEntry<T>> library;
    Notes notes;
    document.root().at(list, LT_TEXT("Engine", "a list")).items(mostLibraryEntries, [&](const JsonCursor& item) {
        const Text text = LT_TEXT("Engine", "a text");
        library.push_back({item.at("key", text).string(), readFields<T>(item, notes, {"key", "source"}),
                           item.at("source", text).string()});
    });
    return library;
}

}  // namespace lathelier::io
