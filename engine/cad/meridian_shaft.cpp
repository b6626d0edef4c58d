#include "engine/cad/meridian_shaft.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;

constexpr double across_mm = 1e-6;

/// Rows of pieces that run in the sense of `sense` along z; a row's arc bulges toward larger radii when positive.
template <class Row>
std::vector<Row> rowsOf(const Contour& pieces, double sense)
{
    std::vector<Row> rows;
    for (const ContourPiece& piece : pieces) {
        const double length = sense * (piece.to_mm.x() - piece.from_mm.x());
        if (!piece.isArc() && std::abs(length) < across_mm) continue;
        Row row;
        row.length_mm = length;
        row.start_diameter_mm = 2 * piece.from_mm.y();
        row.end_diameter_mm = 2 * piece.to_mm.y();
        if (piece.isArc()) row.arc_radius_mm = sense * piece.arc_radius_mm;
        rows.push_back(row);
    }
    return rows;
}

void addBore(Shaft& shaft, ShaftEnd from, const Contour& pieces)
{
    std::vector<BoreSegment> rows = rowsOf<BoreSegment>(pieces, from == ShaftEnd::Free ? 1 : -1);
    if (!rows.empty()) shaft.bores.push_back({from, std::move(rows)});
}

Contour backwards(Contour pieces)
{
    std::reverse(pieces.begin(), pieces.end());
    for (ContourPiece& piece : pieces) piece = piece.reversed();
    return pieces;
}

bool isOnAxis(const ContourPiece& piece)
{
    return piece.from_mm.y() < same_mm && piece.to_mm.y() < same_mm;
}

/// The piece that begins at the outermost point of an end.
std::size_t outermost(const Contour& closed, double z_mm)
{
    std::size_t best = 0;
    double radius = -1;
    for (std::size_t i = 0; i < closed.size(); ++i)
        if (std::abs(closed[i].from_mm.x() - z_mm) < across_mm && closed[i].from_mm.y() > radius)
            radius = closed[i].from_mm.y(), best = i;
    return best;
}

}  // namespace

Shaft shaftOf(const Contour& stated)
{
    Contour closed;
    bool open = false;  // over the axis
    for (const ContourPiece& piece : stated) {
        if (isOnAxis(piece) && !piece.isArc()) continue;
        closed.push_back(piece);
        open |= piece.from_mm.y() < same_mm || piece.to_mm.y() < same_mm;
    }
    Shaft shaft;
    if (closed.empty()) return shaft;
    // If the contour is open at the axis, its last point is not the start of a piece.
    if (open && closed.back().to_mm.y() < same_mm) closed.push_back({closed.back().to_mm, closed.back().to_mm, 0});
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ContourPiece& piece : closed) {
        low = std::min(low, piece.from_mm.x());
        high = std::max(high, piece.from_mm.x());
    }
    const std::size_t start = outermost(closed, low), end = outermost(closed, high);
    Contour outside, inside;
    for (std::size_t i = 0; i < closed.size(); ++i) {
        const std::size_t at = (start + i) % closed.size();
        const std::size_t length = (end + closed.size() - start) % closed.size();
        const bool nothing = (closed[at].to_mm - closed[at].from_mm).norm() == 0;
        if (!nothing) (i < length ? outside : inside).push_back(closed[at]);
    }
    shaft.segments = rowsOf<ShaftSegment>(outside, 1);
    if (!open) {
        addBore(shaft, ShaftEnd::Free, backwards(inside));
        return shaft;
    }
    Contour from_chuck, from_free;
    bool passed = outside.empty() || (!outside.empty() && outside.back().to_mm.y() < same_mm);
    for (const ContourPiece& piece : inside) {
        passed |= piece.from_mm.y() < same_mm;
        (passed ? from_free : from_chuck).push_back(piece);
        passed |= piece.to_mm.y() < same_mm;
    }
    addBore(shaft, ShaftEnd::Free, backwards(from_free));
    addBore(shaft, ShaftEnd::Chuck, from_chuck);
    return shaft;
}

}  // namespace lathelier::cad
