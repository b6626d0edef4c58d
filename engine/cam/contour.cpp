#include "engine/cam/contour.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

double slopeAt(const ContourPiece& piece, const Vector2d& point)
{
    Vector2d along = piece.to_mm - piece.from_mm;
    if (piece.isArc()) {
        const Vector2d out = point - piece.centre_mm();
        // Travel toward larger u: convex arcs are passed clockwise, hollow ones anticlockwise.
        along = piece.arc_radius_mm > 0 ? Vector2d(out.y(), -out.x()) : Vector2d(-out.y(), out.x());
    }
    if (std::abs(along.x()) < 1e-12 * along.norm())
        return std::copysign(std::numeric_limits<double>::infinity(), along.y());
    return along.y() / std::max(along.x(), 1e-300);
}

}  // namespace

HeightContour heightContour(const Shaft& part)
{
    return {outerContour(part), part.length_mm()};
}

HeightContour extendedBy(HeightContour contour, double by_mm)
{
    if (!(by_mm > 0) || contour.pieces.empty()) return contour;
    ContourPiece beyond;
    beyond.from_mm = contour.pieces.back().to_mm;
    beyond.to_mm = beyond.from_mm + Vector2d(by_mm, 0);
    contour.pieces.push_back(beyond);
    return contour;
}

HeightContour mirrored(const HeightContour& contour)
{
    HeightContour result;
    result.length_mm = contour.length_mm;
    if (contour.pieces.empty()) return result;
    const double end = contour.pieces.back().to_mm.x();
    for (auto piece = contour.pieces.rbegin(); piece != contour.pieces.rend(); ++piece) {
        ContourPiece turned = *piece;
        turned.from_mm = {end - piece->to_mm.x(), piece->to_mm.y()};
        turned.to_mm = {end - piece->from_mm.x(), piece->from_mm.y()};
        result.pieces.push_back(turned);
    }
    return result;
}

double startSlope(const ContourPiece& piece)
{
    return slopeAt(piece, piece.from_mm);
}

double endSlope(const ContourPiece& piece)
{
    return slopeAt(piece, piece.to_mm);
}

double lowestRadius_mm(const HeightContour& contour, double from_mm, double to_mm)
{
    double lowest = std::numeric_limits<double>::infinity();
    for (const ContourPiece& piece : contour.pieces) {
        const double low = std::max(from_mm, piece.from_mm.x()), high = std::min(to_mm, piece.to_mm.x());
        if (low > high) continue;
        if (piece.to_mm.x() > piece.from_mm.x()) {
            lowest = std::min({lowest, piece.radiusAt_mm(low), piece.radiusAt_mm(high)});
            if (piece.arc_radius_mm < 0)
                if (const double u = piece.centre_mm().x(); u > low && u < high)
                    lowest = std::min(lowest, piece.radiusAt_mm(u));
        } else {
            lowest = std::min({lowest, piece.from_mm.y(), piece.to_mm.y()});
        }
    }
    return lowest;
}

}  // namespace lathelier::cam
