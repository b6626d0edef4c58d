#include "engine/receptance/library.h"

#include "engine/io/json/library_file.h"

namespace lathelier::receptance {

std::vector<LibraryEntry<Material>> readMaterials(const std::string& json)
{
    auto library = io::readLibrary<Material>(json, "materials");
    for (LibraryEntry<Material>& entry : library) entry.value.name = entry.key;
    return library;
}

std::vector<LibraryEntry<SpindleSprings>> readMachines(const std::string& json)
{
    return io::readLibrary<SpindleSprings>(json, "machines");
}

}  // namespace lathelier::receptance
