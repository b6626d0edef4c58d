#include "widgets/shaft/shaft_question.h"

#include <algorithm>

#include "engine/core/field_within.h"
#include "engine/core/units.h"

namespace lathelier::shaft_panel {
namespace {

/// What is seldom changed is folded away in the form, groups as a whole.
std::vector<Field<ShaftQuestion>> folded(std::vector<Field<ShaftQuestion>> all)
{
    for (Field<ShaftQuestion>& field : all)
        for (const char* start : {"own_material", "springs", "rests"})
            if (field.info.key.starts_with(start)) field.info.advanced = true;
    return all;
}

}  // namespace

const std::vector<Field<Rest>>& fieldsOf(const Rest*)
{
    static const auto all = described<Rest>(
        field("z_mm", &Rest::z_mm, {0, 1e5},
              Label{LT_TEXT("Engine", "z"), LT_TEXT("Engine", "From the free end; 0: a tailstock."), unit::mm}),
        field("radial_N_mm", &Rest::radial_N_mm, {1e-6, 1e12},
              Label{LT_TEXT("Engine", "Stiffness"), LT_TEXT("Engine", "Against deflection."), unit::N_mm}),
        field("loss_factor", &Rest::loss_factor, {0, 2},
              Label{LT_TEXT("Engine", "Loss factor"), LT_TEXT("Engine", "The spring is multiplied by 1 + iη.")}));
    return all;
}

const std::vector<Field<ShaftQuestion>>& fieldsOf(const ShaftQuestion*)
{
    using Q = ShaftQuestion;
    static const auto all = folded(described<Q>(
        rows(segmentsKey, &Q::segments, Range{0, 10000}, part_common::segmentsLabel()),
        field(segmentsOfKey, &Q::segments_of, part_common::segmentsOfLabel()),
        choice("material", &Q::material, receptance::materialChoices(LT_TEXT("Engine", "as the file states")),
               Label{LT_TEXT("Engine", "Material"),
                     LT_TEXT("Engine", "Handbook values of the library are marked as assumed.")}),
        group("own_material", &Q::own_material,
              Label{LT_TEXT("Engine", "Own material"),
                    LT_TEXT("Engine", "Stated in place of the file and the library.")}),
        field("hold", &Q::hold,
              {{"given", LT_TEXT("Engine", "the spindle given, else free")},
               {"springs", LT_TEXT("Engine", "springs")},
               {"clamped", LT_TEXT("Engine", "clamped rigidly")},
               {"free", LT_TEXT("Engine", "free")}},
              Label{LT_TEXT("Engine", "Held at the chuck"), LT_TEXT("Engine", "At the last segment's end.")}),
        group("springs", &Q::springs,
              Label{LT_TEXT("Engine", "Springs at the chuck"), LT_TEXT("Engine", "Where it is held by springs.")}),
        rows("rests", &Q::rests, Range{0, 20},
             Label{LT_TEXT("Engine", "Tailstock and rests"),
                   LT_TEXT("Engine", "Springs between the shaft and the ground.")}),
        within(&Q::response, "respond_z_mm"), within(&Q::response, "excite_z_mm"), within(&Q::response, "from_hz"),
        within(&Q::response, "to_hz"), within(&Q::response, "step_hz"), within(&Q::response, "shear"),
        within(&Q::response, "method"), within(&Q::response, "step_correction")));
    return all;
}

}  // namespace lathelier::shaft_panel
