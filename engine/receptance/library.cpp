#include "engine/receptance/library.h"

#include "engine/io/json/json_fields.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t mostEntries = 1000;

template <class T>
std::vector<LibraryEntry<T>> readLibrary(const std::string& json, const char* list)
{
    const io::JsonDocument document{json};
    std::vector<LibraryEntry<T>> library;
    Notes notes;
    document.root().at(list, LT_TEXT("Engine", "a list")).items(mostEntries, [&](const io::JsonCursor& item) {
        const Text text = LT_TEXT("Engine", "a text");
        library.push_back({item.at("key", text).string(), io::readFields<T>(item, notes, {"key", "source"}),
                           item.at("source", text).string()});
    });
    return library;
}

}  // namespace

std::vector<LibraryEntry<Material>> readMaterials(const std::string& json)
{
    auto library = readLibrary<Material>(json, "materials");
    for (LibraryEntry<Material>& entry : library) entry.value.name = entry.key;
    return library;
}

std::vector<LibraryEntry<SpindleSprings>> readMachines(const std::string& json)
{
    return readLibrary<SpindleSprings>(json, "machines");
}

}  // namespace lathelier::receptance
