#include "engine/cutting/tool_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/core/field_within.h"
#include "engine/core/units.h"
#include "engine/io/json/library_file.h"

namespace lathelier::cutting {
namespace {

constexpr Range depths_mm{0, 1000}, feeds_mm_rev{0, 100}, speeds_m_min{0, 1e5};

/// "cnmg_120408" is CNMG 120408.
std::string nameOfKey(const std::string& key)
{
    std::string name(key);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return c == '_' ? ' ' : static_cast<char>(std::toupper(c)); });
    return name;
}

std::vector<LibraryEntry<LibraryTool>> readTools(const std::string& json, const char* list,
                                                 const std::vector<std::string>& required)
{
    auto entries = io::readLibrary<LibraryTool>(json, list, required);
    for (auto& [key, tool, source] : entries)
        tool.label = fmt::format("{}, {:g}°", tool.name.empty() ? nameOfKey(key) : tool.name, *tool.entering_angle_deg);
    return entries;
}

}  // namespace

const std::vector<Field<CuttingRanges>>& fieldsOf(const CuttingRanges*)
{
    using R = CuttingRanges;
    const Text help = LT_TEXT("Engine", "Range for it.");
    static const auto all = described<R>(
        field("depth_low_mm", &R::depth_low_mm, depths_mm, Label{LT_TEXT("Engine", "Least depth"), help, unit::mm}),
        field("depth_high_mm", &R::depth_high_mm, depths_mm, Label{LT_TEXT("Engine", "Largest depth"), help, unit::mm}),
        field("feed_low_mm_rev", &R::feed_low_mm_rev, feeds_mm_rev,
              Label{LT_TEXT("Engine", "Least feed"), help, unit::mm_rev}),
        field("feed_high_mm_rev", &R::feed_high_mm_rev, feeds_mm_rev,
              Label{LT_TEXT("Engine", "Largest feed"), help, unit::mm_rev}),
        field("speed_low_m_min", &R::speed_low_m_min, speeds_m_min,
              Label{LT_TEXT("Engine", "Least cutting speed"), help, unit::m_min}),
        field("speed_high_m_min", &R::speed_high_m_min, speeds_m_min,
              Label{LT_TEXT("Engine", "Largest cutting speed"), help, unit::m_min}));
    return all;
}

const std::vector<Field<LibraryTool>>& fieldsOf(const LibraryTool*)
{
    using L = LibraryTool;
    static const auto all = [] {
        std::vector<Field<L>> made = lifted<L>(fields<Tool>());
        for (const Field<CuttingRanges>& range : fields<CuttingRanges>())
            made.push_back(within(&L::ranges, range.info.key));
        made.push_back(field("standing", &L::standing,
                             Label{LT_TEXT("Engine", "Standing"), LT_TEXT("Engine", "Given or assumed.")}));
        return made;
    }();
    return all;
}

ToolLibrary readToolLibrary(const std::string& inserts_json, const std::string& holders_json)
{
    return {readTools(inserts_json, "inserts", {"corner_radius_mm", "tip_angle_deg", "entering_angle_deg"}),
            readTools(holders_json, "holders", {"entering_angle_deg"})};
}

const ToolLibrary& toolLibrary()
{
    static const ToolLibrary library = readToolLibrary(builtInInserts().front().text, builtInHolders().front().text);
    return library;
}

const LibraryEntry<LibraryTool>* entryNamed(const std::vector<LibraryEntry<LibraryTool>>& entries,
                                            const std::string& code)
{
    for (const LibraryEntry<LibraryTool>& entry : entries)
        if (plainCode(entry.key) == plainCode(code)) return &entry;
    return nullptr;
}

std::optional<LibraryTool> insertNamed(const std::string& code, const ToolLibrary& library)
{
    if (const LibraryEntry<LibraryTool>* entry = entryNamed(library.inserts, code)) return entry->value;
    const std::optional<Tool> read = toolOfCode(code);
    if (!read) return {};
    return LibraryTool{*read, {}, "given", {}};
}

std::vector<FieldChoice> insertChoices(Text stated, const ToolLibrary& library)
{
    std::vector<FieldChoice> choices{{statedChoice, stated}};
    for (const LibraryEntry<LibraryTool>& entry : library.inserts)
        choices.push_back({entry.key, Text{entry.value.label.c_str()}});
    return choices;
}

bool fitsHolder(const std::string& insert, const std::string& holder)
{
    // "cnmg120408", and "pclnl2525m12" or "sclcl2020k09": clamping, shape, style, clearance, hand, shank, length, edge.
    const std::string of = plainCode(insert), to = plainCode(holder);
    constexpr std::size_t codeLetters = 4, holderLetters = 5;
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    if (of.size() < codeLetters + 2 || to.size() < holderLetters + 2 || !isDigit(of[codeLetters]) ||
        !isDigit(to[holderLetters]))
        return true;
    if (of[0] != to[1] || of[1] != to[3]) return false;
    if (!isDigit(to[to.size() - 1]) || !isDigit(to[to.size() - 2])) return true;
    return of.compare(codeLetters, 2, to, to.size() - 2, 2) == 0;
}

}  // namespace lathelier::cutting
