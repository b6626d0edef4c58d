#include "engine/cad/cad_notes.h"

#include <algorithm>

#include "engine/cad/cad_codes.h"
#include "engine/core/units.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {
namespace {

bool isHoleMark(const ShaftMark& mark)
{
    return mark.kind == MarkKind::CrossHole || mark.kind == MarkKind::BoltCircle;
}

}  // namespace

Notes cadNotes(const Shaft& shaft)
{
    Notes notes;
    // Of a shaft with holes no CAD file is written.
    if (!shaft.marks.empty() && std::none_of(shaft.marks.begin(), shaft.marks.end(), isHoleMark)) {
        std::vector<std::string> seen;
        std::string kinds;
        for (const ShaftMark& mark : shaft.marks) {
            const std::string kind = key(mark);
            if (std::find(seen.begin(), seen.end(), kind) != seen.end()) continue;
            seen.push_back(kind);
            kinds += (kinds.empty() ? "" : ", ") + kind;
        }
        notes.push_back(
            {notes::marksLeftOut, {{"count", static_cast<std::int64_t>(shaft.marks.size())}, {"kinds", kinds}}});
    }
    for (const ContourPiece& piece : outerContour(shaft))
        if (piece.isArc() && piece.centre_mm().y() < -meet_mm)
            notes.push_back({notes::arcBeyondAxis, {{"row", static_cast<std::int64_t>(piece.row + 1)}}});
    return notes;
}

void requireNoHoles(const Shaft& shaft)
{
    const auto size = [](const std::optional<double>& stated) { return stated ? Value(*stated) : Value(); };
    for (const ShaftMark& mark : shaft.marks)
        if (isHoleMark(mark))
            throw Error(errors::holeNotCut, {{"mark", nameOf(mark)},
                                             {"diameter_mm", size(mark.diameter_mm)},
                                             {"z_start_mm", size(mark.z_start_mm)},
                                             {"z_end_mm", size(mark.z_end_mm)}});
}

}  // namespace lathelier::cad
