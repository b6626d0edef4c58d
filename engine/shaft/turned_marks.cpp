#include "engine/shaft/turned_marks.h"

#include <algorithm>

#include "engine/shaft/mark_codes.h"

namespace lathelier {
namespace {

bool isHole(MarkKind kind)
{
    return kind == MarkKind::CrossHole || kind == MarkKind::BoltCircle;
}

template <typename Refused>
void requireNone(const Shaft& shaft, Refused is_refused)
{
    const auto mark = std::find_if(shaft.marks.begin(), shaft.marks.end(),
                                   [&](const ShaftMark& one) { return is_refused(one.kind); });
    if (mark == shaft.marks.end()) return;
    const auto size = [](const std::optional<double>& stated) { return stated ? Value(*stated) : Value(); };
    throw Error(errors::markNotTurned,
                {{"mark", nameOf(*mark)}, {"z_start_mm", size(mark->z_start_mm)}, {"z_end_mm", size(mark->z_end_mm)}});
}

}  // namespace

bool isOtherThanTurned(MarkKind kind)
{
    return kind == MarkKind::Spline || kind == MarkKind::Hexagon || kind == MarkKind::Square ||
           kind == MarkKind::Eccentric;
}

void requireTurned(const Shaft& shaft)
{
    requireNone(shaft, isOtherThanTurned);
}

void requireSolidOfRows(const Shaft& shaft)
{
    requireNone(shaft, [](MarkKind kind) { return isOtherThanTurned(kind) || isHole(kind); });
}

}  // namespace lathelier
