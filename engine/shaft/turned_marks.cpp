#include "engine/shaft/turned_marks.h"

#include "engine/shaft/mark_codes.h"

namespace lathelier {

bool isOtherThanTurned(MarkKind kind)
{
    return kind == MarkKind::Spline || kind == MarkKind::Hexagon || kind == MarkKind::Square ||
           kind == MarkKind::Eccentric;
}

void requireTurned(const Shaft& shaft)
{
    for (const ShaftMark& mark : shaft.marks)
        if (isOtherThanTurned(mark.kind))
            throw Error(errors::markNotTurned, {{"mark", nameOf(mark)},
                                                {"z_start_mm", mark.z_start_mm.value_or(0)},
                                                {"z_end_mm", mark.z_end_mm.value_or(0)}});
}

}  // namespace lathelier
