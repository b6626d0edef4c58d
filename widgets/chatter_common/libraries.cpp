#include "widgets/chatter_common/libraries.h"

#include "engine/cutting/tool_library.h"
#include "widgets/core/resources.h"

namespace lathelier::chatter_common {
namespace {

template <class T, class E>
Chosen<T> chosenOf(const std::vector<LibraryEntry<T>>& library, const std::vector<FieldChoice>& choices, E choice)
{
    if (choice == E::Stated) return {nullptr, {}};
    const FieldChoice& named = choices.at(static_cast<std::size_t>(choice));
    return {entryOf(library, named.key), named.label};
}

}  // namespace

std::vector<FieldChoice> materialChoices(Text stated)
{
    return {{"stated", stated},
            {"steel", LT_TEXT("Engine", "Steel")},
            {"stainless", LT_TEXT("Engine", "Stainless steel")},
            {"aluminium", LT_TEXT("Engine", "Aluminium")},
            {"brass", LT_TEXT("Engine", "Brass")},
            {"titanium", LT_TEXT("Engine", "Titanium")},
            {"cast_iron", LT_TEXT("Engine", "Cast iron")}};
}

std::vector<FieldChoice> machineChoices(Text stated)
{
    return {{"stated", stated},
            {"papers", LT_TEXT("Engine", "lathe of the papers")},
            {"stiff", LT_TEXT("Engine", "stiff lathe (example)")},
            {"soft", LT_TEXT("Engine", "soft lathe (example)")}};
}

std::vector<FieldChoice> insertChoices(Text stated)
{
    return {{"stated", stated},
            {"cnmg_120404", LT_TEXT("Engine", "CNMG 120404, 95°")},
            {"cnmg_120408", LT_TEXT("Engine", "CNMG 120408, 95°")},
            {"cnmg_120412", LT_TEXT("Engine", "CNMG 120412, 95°")},
            {"wnmg_080408", LT_TEXT("Engine", "WNMG 080408, 95°")},
            {"dnmg_150608", LT_TEXT("Engine", "DNMG 150608, 93°")},
            {"vnmg_160404", LT_TEXT("Engine", "VNMG 160404, 93°")},
            {"tnmg_160408", LT_TEXT("Engine", "TNMG 160408, 93°")},
            {"snmg_120408", LT_TEXT("Engine", "SNMG 120408, 75°")},
            {"ccmt_09t304", LT_TEXT("Engine", "CCMT 09T304, 95°")},
            {"dcmt_11t304", LT_TEXT("Engine", "DCMT 11T304, 93°")}};
}

Chosen<Material> chosen(MaterialChoice choice)
{
    static const auto library = receptance::readMaterials(resourceText(":/library/materials.json"));
    return chosenOf(library, materialChoices({}), choice);
}

Chosen<receptance::SpindleSprings> chosen(MachineChoice choice)
{
    static const auto library = receptance::readMachines(resourceText(":/library/machines.json"));
    return chosenOf(library, machineChoices({}), choice);
}

Chosen<Tool> chosen(InsertChoice choice)
{
    // What the forces need; the edge of the check against stock stays assumed, as the panels have it.
    static const auto library = [] {
        std::vector<LibraryEntry<Tool>> inserts;
        for (const auto& [key, tool, source] : cutting::toolLibrary().inserts)
            inserts.push_back({key,
                               {.corner_radius_mm = tool.corner_radius_mm,
                                .entering_angle_deg = tool.entering_angle_deg,
                                .tip_angle_deg = tool.tip_angle_deg},
                               source});
        return inserts;
    }();
    return chosenOf(library, insertChoices({}), choice);
}

}  // namespace lathelier::chatter_common
