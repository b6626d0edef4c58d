#include "engine/cad/cad_notes.h"

#include <fmt/format.h>

#include "engine/cad/cad_codes.h"
#include "engine/core/units.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {
namespace {

constexpr std::int64_t mostNamed = 12;  // marks in one note

/// "keyway z 6.0-34.0"
std::string placed(const ShaftMark& mark)
{
    if (!mark.z_start_mm || !mark.z_end_mm) return key(mark);
    return fmt::format("{} z {:.1f}-{:.1f}", key(mark), *mark.z_start_mm, *mark.z_end_mm);
}

}  // namespace

Notes cadNotes(const Shaft& shaft)
{
    Notes notes;
    std::int64_t left_out = 0;
    std::string marks;
    for (const ShaftMark& mark : shaft.marks) {
        if (mark.kind == MarkKind::Sphere) continue;  // made of its row
        if (left_out < mostNamed) marks += (left_out > 0 ? ", " : "") + placed(mark);
        if (left_out == mostNamed) marks += ", …";
        ++left_out;
    }
    if (left_out > 0) notes.push_back({notes::marksLeftOut, {{"count", left_out}, {"kinds", marks}}});
    for (const ContourPiece& piece : outerContour(shaft))
        if (piece.isArc() && piece.centre_mm().y() < -meet_mm)
            notes.push_back({notes::arcBeyondAxis, {{"row", static_cast<std::int64_t>(piece.row + 1)}}});
    return notes;
}

}  // namespace lathelier::cad
