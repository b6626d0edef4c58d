#include "engine/gcode/contour_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace lathelier::gcode {
namespace {

constexpr double sameDirection = 1e-9;  ///< sine between directions that are the same up to rounding
constexpr double clearCorner = 1e-4;    ///< sine of a corner of two lines that is surely one
/// Outer corners whose ends lie apart by less along the feed are joined without an arc; in the unit of the program, as
/// observed.
constexpr double leastGap = 0.01;
/// Contours with shorter pieces are joined in other ways, too.
constexpr double leastWholePiece = 0.05;
constexpr double leastPiece = 1e-5;  ///< of what remains of a piece

/// Sine of the turn to the left.
double turnBetween(const Direction& a, const Direction& b)
{
    return a.z * b.x - a.x * b.z;
}

bool isSameWay(const Direction& a, const Direction& b)
{
    return a.x * b.x + a.z * b.z > 0;
}

/// Does the cut piece run as the whole one? One that vanished runs backwards.
bool isPartOf(const Piece& cut, const Piece& whole)
{
    if (distance_mm(cut.from, cut.to) < leastWholePiece) return false;
    if (!whole.isArc()) return isSameWay(directionAtStart(cut), directionAtStart(whole));
    return sweepOf(cut) <= sweepOf(whole) + 0.5;
}

/// Appends `next` to the pieces, the last of which is cut where they meet.
ContourAtDistance::State join(std::vector<Piece>& pieces, Piece next, const Piece& before, const Piece& after,
                              double left, bool is_face)
{
    using State = ContourAtDistance::State;
    const Direction in = directionAtEnd(before), out = directionAtStart(after);
    const double turn = turnBetween(in, out);
    const bool isStraight = !before.isArc() && !after.isArc();
    const Point& end = pieces.back().to;
    const double gap = std::abs(is_face ? end.x_mm - next.from.x_mm : end.z_mm - next.from.z_mm);
    if (isStraight && std::abs(turn) < clearCorner)
        return turn == 0 && (in.x == 0 || in.z == 0) && isSameWay(in, out) ? State::Parallel : State::Unsure;
    if (std::abs(turn) < sameDirection && isSameWay(in, out)) {
        next.from = end;
    } else if (turn * left < 0 && gap >= leastGap) {
        if (gap < leastGap + 1e-8) return State::Unsure;
        pieces.push_back({end, next.from, after.from, turn < 0});
    } else if (!isStraight) {
        return State::Unsure;  // which of the two intersections of an arc is taken is not known
    } else {
        const auto at = meeting(pieces.back(), next, after.from);
        if (!at) return State::Unsure;
        pieces.back().to = next.from = *at;
    }
    pieces.push_back(next);
    return State::Made;
}

}  // namespace

double sweepOf(const Piece& piece)
{
    if (!piece.isArc()) return 0;
    const auto angle = [&piece](const Point& at) {
        return std::atan2(at.x_mm - piece.centre.x_mm, at.z_mm - piece.centre.z_mm);
    };
    const double along = (piece.clockwise ? -1 : 1) * (angle(piece.to) - angle(piece.from));
    return along < 0 ? along + 2 * std::numbers::pi : along;
}

ContourAtDistance contourAtDistance(const std::vector<Piece>& contour, double left, bool is_face)
{
    using State = ContourAtDistance::State;
    ContourAtDistance result;
    if (left == 0) {
        result.pieces = contour;
        return result;
    }
    std::vector<Piece> whole;
    std::vector<std::size_t> places;  // of the shifted pieces among those of the result
    for (std::size_t i = 0; i < contour.size() && result.state == State::Made; ++i) {
        const std::optional<Piece> next = shifted(contour[i], left);
        // An arc whose radius nearly vanishes is left open as one that does.
        if (!next || (next->isArc() && next->radius_mm() < leastPiece) ||
            distance_mm(contour[i].from, contour[i].to) < leastWholePiece) {
            result.state = State::Unsure;
            break;
        }
        whole.push_back(*next);
        if (i == 0)
            result.pieces.push_back(*next);
        else
            result.state = join(result.pieces, *next, contour[i - 1], contour[i], left, is_face);
        places.push_back(result.pieces.size() - 1);
    }
    for (std::size_t i = 0; i < whole.size() && result.state == State::Made; ++i)
        if (!isPartOf(result.pieces[places[i]], whole[i])) result.state = State::Unsure;
    return result;
}

}  // namespace lathelier::gcode
