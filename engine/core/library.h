// A library of default values, each with a key and its source.
#pragma once

#include <string>
#include <vector>

namespace lathelier {

/// Key of the choice that takes nothing from a library.
inline constexpr const char* statedChoice = "stated";

/// One entry of a library.
template <class T>
struct LibraryEntry {
    std::string key;  ///< by which it is chosen: "steel"
    T value;
    std::string source;  ///< reference
};

/// The entry with this key; nullptr: there is none.
template <class T>
const LibraryEntry<T>* entryOf(const std::vector<LibraryEntry<T>>& library, const std::string& key)
{
    for (const LibraryEntry<T>& entry : library)
        if (entry.key == key) return &entry;
    return nullptr;
}

}  // namespace lathelier
