#include "engine/shop/shop.h"

#include "engine/cam/required_label.h"
#include "engine/cam/task/turn_question.h"
#include "engine/core/units.h"
#include "engine/receptance/library.h"

namespace lathelier::shop {
namespace {

using cam::required;

constexpr double longest_mm = 1e5;
constexpr Range sizes_mm{1e-3, longest_mm}, distances_mm{0, longest_mm}, stiffness{0, 1e18};

template <class T>
Field<T> nameField()
{
    return field("name", &T::name, Label{LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "As it is shown.")});
}

std::vector<FieldChoice> elasticMaterials()
{
    std::vector<FieldChoice> choices;
    for (const auto& entry : receptance::materials())
        choices.push_back({entry.key, receptance::nameOfMaterial(entry.key)});
    return choices;
}

}  // namespace

const std::vector<Field<Lathe>>& fieldsOf(const Lathe*)
{
    using L = Lathe;
    static const auto all = described<L>(
        nameField<L>(),
        field("max_rpm", &L::max_rpm, {1, 1e5},
              required(LT_TEXT("Engine", "Largest speed"), LT_TEXT("Engine", "Of the spindle."),
                       LT_TEXT("Engine", "rpm"))),
        field("power_kW", &L::power_kW, {0.01, 1e4},
              Label{LT_TEXT("Engine", "Power of the motor"), LT_TEXT("Engine", "Empty: not looked at."),
                    LT_TEXT("Engine", "kW")}),
        field("efficiency", &L::efficiency, {0.1, 1},
              Label{LT_TEXT("Engine", "Efficiency"), LT_TEXT("Engine", "Of the way from the motor to the cut.")}),
        field("swing_mm", &L::swing_mm, sizes_mm,
              Label{LT_TEXT("Engine", "Swing"), LT_TEXT("Engine", "Largest diameter of a part; empty: not looked at."),
                    unit::mm}),
        field("distance_mm", &L::distance_mm, sizes_mm,
              Label{LT_TEXT("Engine", "Turning length"),
                    LT_TEXT("Engine", "Largest length of a part; empty: not looked at."), unit::mm}),
        choice("post", &L::post, cam::postChoices(),
               Label{LT_TEXT("Engine", "Control"), LT_TEXT("Engine", "For which programs are written.")}));
    return all;
}

const std::vector<Field<Chuck>>& fieldsOf(const Chuck*)
{
    using C = Chuck;
    static const auto all =
        described<C>(nameField<C>(),
                     group("springs", &C::springs,
                           Label{LT_TEXT("Engine", "Chuck face"), LT_TEXT("Engine", "With the spindle behind it.")}),
                     field("jaw_diameter_mm", &C::jaw_diameter_mm, sizes_mm,
                           Label{LT_TEXT("Engine", "Jaws ⌀"),
                                 LT_TEXT("Engine", "Empty: everything beyond the chuck face is the chuck."), unit::mm}),
                     field("grip_length_mm", &C::grip_length_mm, distances_mm,
                           Label{LT_TEXT("Engine", "Length of the grip"),
                                 LT_TEXT("Engine", "The least length to be held."), unit::mm}),
                     field("clearance_mm", &C::clearance_mm, distances_mm,
                           Label{LT_TEXT("Engine", "Clearance"),
                                 LT_TEXT("Engine", "From the part's end to the chuck face."), unit::mm}));
    return all;
}

const std::vector<Field<Tailstock>>& fieldsOf(const Tailstock*)
{
    using T = Tailstock;
    static const auto all = described<T>(
        nameField<T>(),
        field("radial_N_mm", &T::radial_N_mm, stiffness,
              required(LT_TEXT("Engine", "Radial stiffness"), LT_TEXT("Engine", "Against deflection."), unit::N_mm)),
        field("tilt_N_mm_rad", &T::tilt_N_mm_rad, stiffness,
              Label{LT_TEXT("Engine", "Tilting stiffness"),
                    LT_TEXT("Engine", "Against tilting of the axis; 0: a pointed centre."),
                    LT_TEXT("Engine", "N·mm/rad")}),
        field("centre_hole_mm", &T::centre_hole_mm, distances_mm,
              Label{LT_TEXT("Engine", "Centre hole ⌀"), LT_TEXT("Engine", "Its largest diameter."), unit::mm}),
        field("from_slenderness", &T::from_slenderness, {0, 1000},
              Label{LT_TEXT("Engine", "From slenderness"),
                    LT_TEXT("Engine", "Used where length over mean diameter is that large.")}));
    return all;
}

const std::vector<Field<ToolSet>>& fieldsOf(const ToolSet*)
{
    using S = ToolSet;
    static const auto all = described<S>(
        nameField<S>(), rows("tools", &S::tools, {1, 100},
                             Label{LT_TEXT("Engine", "Tools"), LT_TEXT("Engine", "In the turret, by their number.")}));
    return all;
}

const std::vector<Field<BarMaterial>>& fieldsOf(const BarMaterial*)
{
    using M = BarMaterial;
    static const auto all = described<M>(
        nameField<M>(),
        choice("elastic", &M::elastic, elasticMaterials(),
               Label{LT_TEXT("Engine", "Stiffness and density"), LT_TEXT("Engine", "Of this material.")}),
        group("cutting", &M::cutting,
              Label{LT_TEXT("Engine", "Cutting forces"), LT_TEXT("Engine", "With a coated carbide insert.")}),
        group("rough", &M::rough, Label{LT_TEXT("Engine", "Roughing"), {}}),
        group("finish", &M::finish, Label{LT_TEXT("Engine", "Finishing"), {}}),
        field("diameter_allowance_mm", &M::diameter_allowance_mm, distances_mm,
              Label{LT_TEXT("Engine", "Allowance of the bar"),
                    LT_TEXT("Engine", "Its diameter beyond the largest of the part, at least."), unit::mm}),
        field("face_allowance_mm", &M::face_allowance_mm, distances_mm,
              Label{LT_TEXT("Engine", "Allowance of the face"),
                    LT_TEXT("Engine", "How far the raw end stands before the finished one."), unit::mm}));
    return all;
}

}  // namespace lathelier::shop
