#include "engine/cad/cad_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/cad/cad_codes.h"
#include "engine/core/units.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {
namespace {

constexpr std::int64_t mostNamed = 12;  // marks in one note
constexpr std::array notTurned{MarkKind::Hexagon,   MarkKind::Square,    MarkKind::Spline,
                               MarkKind::Eccentric, MarkKind::CrossHole, MarkKind::BoltCircle};

bool isTurned(const ShaftMark& mark)
{
    return std::find(notTurned.begin(), notTurned.end(), mark.kind) == notTurned.end();
}

/// "keyway z 6.0-34.0"
std::string placed(const ShaftMark& mark)
{
    if (!mark.z_start_mm || !mark.z_end_mm) return key(mark);
    return fmt::format("{} z {:.1f}-{:.1f}", key(mark), *mark.z_start_mm, *mark.z_end_mm);
}

/// The marks that a solid of the rows leaves out; none where no solid is made.
void remarkLeftOut(const std::vector<ShaftMark>& all, Notes& notes)
{
    if (!std::all_of(all.begin(), all.end(), isTurned)) return;
    std::int64_t left_out = 0;
    std::string marks;
    for (const ShaftMark& mark : all) {
        if (mark.kind == MarkKind::Sphere) continue;  // made of its row
        if (left_out < mostNamed) marks += (left_out > 0 ? ", " : "") + placed(mark);
        if (left_out == mostNamed) marks += ", …";
        ++left_out;
    }
    if (left_out > 0) notes.push_back({notes::marksLeftOut, {{"count", left_out}, {"kinds", marks}}});
}

}  // namespace

Notes cadNotes(const Shaft& shaft)
{
    Notes notes;
    remarkLeftOut(shaft.marks, notes);
    for (const ContourPiece& piece : outerContour(shaft))
        if (piece.isArc() && piece.centre_mm().y() < -meet_mm)
            notes.push_back({notes::arcBeyondAxis, {{"row", static_cast<std::int64_t>(piece.row + 1)}}});
    return notes;
}

void requireTurned(const Shaft& shaft)
{
    const auto size = [](const std::optional<double>& stated) { return stated ? Value(*stated) : Value(); };
    for (const ShaftMark& mark : shaft.marks)
        if (!isTurned(mark))
            throw Error(
                errors::markNotMade,
                {{"kind", nameOf(mark)}, {"z_start_mm", size(mark.z_start_mm)}, {"z_end_mm", size(mark.z_end_mm)}});
}

}  // namespace lathelier::cad
