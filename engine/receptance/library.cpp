#include "engine/receptance/library.h"

#include "engine/receptance/receptance_codes.h"

#include <algorithm>
#include <string_view>

#include "engine/io/json/library_file.h"

namespace lathelier::receptance {
namespace {

const std::string& builtInModel(const char* name)
{
    const std::vector<BuiltInText>& all = builtInModels();
    return std::find_if(all.begin(), all.end(),
                        [&](const BuiltInText& text) { return std::string_view(text.name) == name; })
        ->text;
}

/// The label of a known key, else the key of the entry itself, which lives as long as the program.
template <class T>
Text labelOf(const std::vector<FieldChoice>& known, const std::vector<LibraryEntry<T>>& library, const std::string& key)
{
    for (const FieldChoice& choice : known)
        if (choice.key == key) return choice.label;
    const LibraryEntry<T>* const entry = entryOf(library, key);
    return entry ? Text{entry->key.c_str()} : Text{};
}

template <class T, class NameOf>
std::vector<FieldChoice> choicesOf(const std::vector<LibraryEntry<T>>& library, Text stated, NameOf nameOf)
{
    std::vector<FieldChoice> choices{{statedChoice, stated}};
    for (const LibraryEntry<T>& entry : library) choices.push_back({entry.key, nameOf(entry.key)});
    return choices;
}

}  // namespace

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

const std::vector<LibraryEntry<Material>>& materials()
{
    static const auto all = readMaterials(builtInModel("materials"));
    return all;
}

const std::vector<LibraryEntry<SpindleSprings>>& machines()
{
    static const auto all = readMachines(builtInModel("machines"));
    return all;
}

Text nameOfMaterial(const std::string& key)
{
    static const std::vector<FieldChoice> known{
        {"steel", LT_TEXT("Engine", "Steel")},         {"stainless", LT_TEXT("Engine", "Stainless steel")},
        {"aluminium", LT_TEXT("Engine", "Aluminium")}, {"brass", LT_TEXT("Engine", "Brass")},
        {"titanium", LT_TEXT("Engine", "Titanium")},   {"cast_iron", LT_TEXT("Engine", "Cast iron")}};
    return labelOf(known, materials(), key);
}

Text nameOfMachine(const std::string& key)
{
    static const std::vector<FieldChoice> known{{"papers", LT_TEXT("Engine", "lathe of the papers")},
                                                {"stiff", LT_TEXT("Engine", "stiff lathe (example)")},
                                                {"soft", LT_TEXT("Engine", "soft lathe (example)")}};
    return labelOf(known, machines(), key);
}

std::vector<FieldChoice> materialChoices(Text stated)
{
    return choicesOf(materials(), stated, nameOfMaterial);
}

std::vector<FieldChoice> machineChoices(Text stated)
{
    return choicesOf(machines(), stated, nameOfMachine);
}

bool chooseMaterial(const std::string& choice, Shaft& shaft, Notes& notes)
{
    const auto* const entry = entryOf(materials(), choice);
    if (!entry) return false;
    shaft.material = entry->value;
    notes.push_back({notes::materialOfLibrary, {{"material", nameOfMaterial(choice)}, {"source", entry->source}}});
    return true;
}

}  // namespace lathelier::receptance
