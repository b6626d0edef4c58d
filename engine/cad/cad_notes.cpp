#include "engine/cad/cad_notes.h"

#include <algorithm>

#include "engine/cad/cad_codes.h"
#include "engine/core/units.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {

Notes cadNotes(const Shaft& shaft)
{
    Notes notes;
    std::vector<std::string> seen;
    std::string kinds;
    std::int64_t count = 0;
    for (const ShaftMark& mark : shaft.marks) {
        if (mark.kind == MarkKind::Sphere) continue;  // the rows show it
        ++count;
        const std::string kind = key(mark);
        if (std::find(seen.begin(), seen.end(), kind) != seen.end()) continue;
        seen.push_back(kind);
        kinds += (kinds.empty() ? "" : ", ") + kind;
    }
    if (count > 0) notes.push_back({notes::marksLeftOut, {{"count", count}, {"kinds", kinds}}});
    for (const ContourPiece& piece : outerContour(shaft))
        if (piece.isArc() && piece.centre_mm().y() < -meet_mm)
            notes.push_back({notes::arcBeyondAxis, {{"row", static_cast<std::int64_t>(piece.row + 1)}}});
    return notes;
}

}  // namespace lathelier::cad
