// Libraries of materials and of machines to begin with: values that are assumed until those at hand are stated.
// Files: {"about", "materials": [{"key", fields of Material, "source"}…]} and {"about", "machines": [{"key", fields of
// SpindleSprings, "source"}…]}.
#pragma once

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/material.h"
#include "engine/receptance/spindle_receptance.h"

namespace lathelier::receptance {

/// One entry of a library.
template <class T>
struct LibraryEntry {
    std::string key;     ///< by which it is chosen: "steel"
    T value;             ///< what it stands for
    std::string source;  ///< where the values come from
};

/// Errors with line and column: malformed, keyMissing, keyOutOfRange. The name of a material is its key.
std::vector<LibraryEntry<Material>> readMaterials(const std::string& json);
std::vector<LibraryEntry<SpindleSprings>> readMachines(const std::string& json);

/// The entry with this key; nullptr: there is none.
template <class T>
const LibraryEntry<T>* entryOf(const std::vector<LibraryEntry<T>>& library, const std::string& key)
{
    for (const LibraryEntry<T>& entry : library)
        if (entry.key == key) return &entry;
    return nullptr;
}

}  // namespace lathelier::receptance
