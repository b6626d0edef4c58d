// The parameters of a check as fields, and the names of its findings.
#include <array>

#include "engine/cam/check/turning_check.h"
#include "engine/core/field_within.h"
#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

struct NamedCheck {
    const char* key;
    Text name;
};

const std::array<NamedCheck, 6>& checkNames()
{
    static const std::array<NamedCheck, 6> all{{{"rapid_through_stock", LT_TEXT("Engine", "rapid move through stock")},
                                                {"holder_in_stock", LT_TEXT("Engine", "holder in stock")},
                                                {"insert_below_drawing", LT_TEXT("Engine", "insert below the drawing")},
                                                {"chuck", LT_TEXT("Engine", "chuck")},
                                                {"tailstock", LT_TEXT("Engine", "tailstock")},
                                                {"standing_end", LT_TEXT("Engine", "end that was not cut off")}}};
    return all;
}

}  // namespace

const char* key(CheckKind kind)
{
    return checkNames().at(static_cast<std::size_t>(kind)).key;
}

Text nameOf(CheckKind kind)
{
    return checkNames().at(static_cast<std::size_t>(kind)).name;
}

const std::vector<Field<CheckParameters>>& fieldsOf(const CheckParameters*)
{
    using P = CheckParameters;
    const Range place{-1e5, 1e5};
    static const auto all = described<P>(
        within(&P::program, "dialect"), foldedWithin(&P::program, "integer_words"),
        foldedWithin(&P::program, "arc_tolerance_um"), foldedWithin(&P::program, "subprograms"),
        field("setup", &P::setup, {1, 2},
              Label{LT_TEXT("Engine", "Clamping"),
                    LT_TEXT("Engine", "2: the part is turned round, and z counts from its other end.")}),
        field("z_zero_mm", &P::z_zero_mm, place,
              Label{LT_TEXT("Engine", "z of the program's zero"),
                    LT_TEXT("Engine", "z = this less the program's Z; 0: the program's zero is the free end."),
                    unit::mm}),
        field("finished_from_mm", &P::finished_from_mm, place,
              Label{LT_TEXT("Engine", "Finished from z"),
                    LT_TEXT("Engine", "What is left counts from here; empty: from the free end."), unit::mm}),
        field("finished_to_mm", &P::finished_to_mm, place,
              Label{LT_TEXT("Engine", "Finished up to z"),
                    LT_TEXT("Engine", "What is left counts up to here; empty: to the end of the part."), unit::mm}),
        field("chuck_face_z_mm", &P::chuck_face_z_mm, place,
              Label{LT_TEXT("Engine", "z of the chuck face"),
                    LT_TEXT("Engine",
                            "In this clamping; empty: as the job states for the first, not looked at in the "
                            "second."),
                    unit::mm}),
        field(
            "work_length_mm", &P::work_length_mm, Range{1e-3, 1e5},
            Label{LT_TEXT("Engine", "Length of the work"),
                  LT_TEXT("Engine",
                          "Before the second clamping, from the finished face; empty: as a stop of the program or the "
                          "job states it."),
                  unit::mm}),
        field("dog_leg", &P::dog_leg,
              Label{LT_TEXT("Engine", "Dog-leg"),
                    LT_TEXT("Engine", "Try the dog-leg of rapid moves besides the straight line."),
                    {},
                    true}));
    return all;
}

}  // namespace lathelier::cam
