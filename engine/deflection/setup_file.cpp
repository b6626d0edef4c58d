#include "engine/deflection/setup_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/deflection/deflection_codes.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_fields.h"
#include "engine/io/json/json_head.h"
#include "engine/io/shaft/shaft_file.h"

namespace lathelier::deflection {
namespace {

io::Likeness likeSetup(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    if (io::hasKey(keys, "command") || !io::hasKey(keys, "chuck")) return io::Likeness::No;
    return io::hasKey(keys, "tool") && io::hasKey(keys, "material") ? io::Likeness::Certain : io::Likeness::Likely;
}

/// Throws keyMissing for a required group.
void requireGroup(const io::JsonCursor& root, const char* key, Text expected)
{
    root.at(key, expected);
}

SetupFile readNamed(const io::FileToRead& file)
{
    SetupFile loaded;
    try {
        loaded.setup = readSetup(std::string(file.bytes), loaded.notes);
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    for (Note& note : loaded.notes) set(note.values, "path", file.path);
    const TurningSetup& setup = loaded.setup;
    io::FileFacts& facts = loaded.facts;
    facts.path = file.path;
    facts.format = "setup_json";
    set(facts.details, "stock", setup.stock.empty() ? Value() : Value(setup.stock));
    set(facts.details, "tailstock", setup.tailstock.has_value());
    set(facts.details, "steady_rests", static_cast<std::int64_t>(setup.steady_rests.size()));
    set(facts.details, "follower_rest", setup.follower_rest.has_value());
    set(facts.details, "K_tc_N_mm2", setup.material.cutting.K_tc_N_mm2);
    return loaded;
}

}  // namespace

TurningSetup readSetup(const std::string& json, Notes& notes)
{
    const io::JsonDocument document{json};
    const io::JsonCursor root = document.root();
    if (!root.isObject()) root.reject(LT_TEXT("Engine", "an object with material, tool and chuck"));
    requireGroup(root, "material", LT_TEXT("Engine", "the material of the work"));
    requireGroup(root, "tool", LT_TEXT("Engine", "the insert"));
    requireGroup(root, "chuck", LT_TEXT("Engine", "the springs of the chuck"));
    auto setup = io::readFields<TurningSetup>(root, notes);
    noteSprings(setup, notes);
    return setup;
}

void noteSprings(const TurningSetup& setup, Notes& notes)
{
    const auto is_stated = [](const HoldingSprings& springs) {
        return springs.axial_N_mm > 0 || springs.torsion_N_mm_rad > 0;
    };
    if (is_stated(setup.chuck) || (setup.tailstock && is_stated(*setup.tailstock)))
        notes.push_back({notes::springsBesideDiameter, {}});
}

std::string setupText(const TurningSetup& setup)
{
    return io::objectOf(infos<TurningSetup>(), lathelier::toValues(setup)).dump(2) + "\n";
}

SetupFile loadSetup(const io::FileToRead& file)
{
    SetupFile loaded = readNamed(file);
    if (loaded.setup.stock.empty()) return loaded;
    const std::string beside = (std::filesystem::path(file.path).parent_path() / loaded.setup.stock).string();
    Notes of_stock;
    try {
        loaded.stock = io::readShaftFile(file.inputs.open(beside, file.progress), of_stock, file.progress);
    } catch (Error& error) {
        throw error.with("path", beside);
    }
    for (Note& note : of_stock) {
        set(note.values, "path", beside);
        loaded.notes.push_back(std::move(note));
    }
    return loaded;
}

const io::FileKind& setupFiles()
{
    static const io::FileKind kind{"setup",
                                   LT_TEXT("Engine", "Set-ups"),
                                   "*.json",
                                   {},
                                   {},
                                   likeSetup,
                                   [](const io::FileToRead& file, Notes& notes) {
                                       SetupFile loaded = readNamed(file);
                                       notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
                                       return std::move(loaded.facts);
                                   }};
    return kind;
}

}  // namespace lathelier::deflection
