#include "engine/cutting/insert_library.h"

#include <fmt/format.h>

#include <cctype>
#include <map>

#include "engine/io/json/library_file.h"

namespace lathelier::cutting {

std::vector<LibraryEntry<ToolGeometry>> readInserts(const std::string& json)
{
    return io::readLibrary<ToolGeometry>(json, "inserts");
}

const std::vector<LibraryEntry<ToolGeometry>>& inserts()
{
    static const auto all = readInserts(builtInInserts().front().text);
    return all;
}

Text nameOfInsert(const std::string& key)
{
    // "cnmg_120404" is CNMG 120404; an entry lives as long as the program, and so do the names.
    static const auto names = [] {
        std::map<std::string, std::string> all;
        for (const LibraryEntry<ToolGeometry>& entry : inserts()) {
            std::string name;
            for (const char c : entry.key)
                name += c == '_' ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
            name += fmt::format(", {:g}°", 90 - entry.value.lead_angle_deg);
            all.emplace(entry.key, std::move(name));
        }
        return all;
    }();
    const auto found = names.find(key);
    return found == names.end() ? Text{} : Text{found->second.c_str()};
}

std::vector<FieldChoice> insertChoices(Text stated)
{
    std::vector<FieldChoice> choices{{statedChoice, stated}};
    for (const LibraryEntry<ToolGeometry>& entry : inserts()) choices.push_back({entry.key, nameOfInsert(entry.key)});
    return choices;
}

}  // namespace lathelier::cutting
