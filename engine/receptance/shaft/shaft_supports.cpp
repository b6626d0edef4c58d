#include "engine/receptance/shaft/shaft_supports.h"

#include "engine/core/units.h"

namespace lathelier::receptance {
namespace {

constexpr Range stiffnesses{1e-6, 1e12};

Label lossLabel()
{
    return {LT_TEXT("Engine", "Loss factor"), LT_TEXT("Engine", "The spring is multiplied by 1 + iη.")};
}

}  // namespace

const std::vector<Field<Tailstock>>& fieldsOf(const Tailstock*)
{
    static const auto all = described<Tailstock>(
        field("radial_N_mm", &Tailstock::radial_N_mm, stiffnesses,
              Label{LT_TEXT("Engine", "Stiffness"), LT_TEXT("Engine", "Against deflection."), unit::N_mm, false, true}),
        field("tilt_N_mm_rad", &Tailstock::tilt_N_mm_rad, {0, 1e15},
              Label{LT_TEXT("Engine", "Tilt stiffness"), LT_TEXT("Engine", "Against rotation; 0: none."),
                    LT_TEXT("Engine", "N·mm/rad")}));
    return all;
}

const std::vector<Field<Rest>>& fieldsOf(const Rest*)
{
    static const auto all = described<Rest>(
        field("z_mm", &Rest::z_mm, {0, 1e5},
              Label{LT_TEXT("Engine", "z"), LT_TEXT("Engine", "From the free end."), unit::mm, false, true}),
        field("radial_N_mm", &Rest::radial_N_mm, stiffnesses,
              Label{LT_TEXT("Engine", "Stiffness"), LT_TEXT("Engine", "Against deflection."), unit::N_mm, false, true}),
        field("loss_factor", &Rest::loss_factor, {0, 2}, lossLabel()));
    return all;
}

const std::vector<Field<ShaftSupports>>& fieldsOf(const ShaftSupports*)
{
    using S = ShaftSupports;
    static const std::vector<Field<S>> all = [] {
        std::vector<Field<S>> made{
            rows("tailstock", &S::tailstock, Range{0, 1},
                 Label{LT_TEXT("Engine", "Tailstock"),
                       LT_TEXT("Engine", "A centre at z 0: radial and tilt stiffness.")}),
            rows("rest", &S::rest, Range{0, 20},
                 Label{LT_TEXT("Engine", "Steady rests"),
                       LT_TEXT("Engine", "Springs between the shaft and the ground: z and radial stiffness.")})};
        made[1].info.former = {{"rests"}};
        return made;
    }();
    return all;
}

std::vector<beam::Support> supportsOf(const ShaftSupports& supports)
{
    std::vector<beam::Support> all;
    for (const Tailstock& centre : supports.tailstock)
        all.push_back({0, centre.radial_N_mm, centre.tilt_N_mm_rad, Rest{}.loss_factor});
    for (const Rest& rest : supports.rest) all.push_back({rest.z_mm, rest.radial_N_mm, 0, rest.loss_factor});
    return all;
}

}  // namespace lathelier::receptance
