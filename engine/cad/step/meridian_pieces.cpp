#include "engine/cad/step/meridian_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;

constexpr double wholeTurn = 1 - 1e-5;  ///< share of the circle above which a face runs all round
constexpr double touching_mm = 1e-4;    ///< as the distance of coincident ends

double sweptArea_mm2(const ContourPiece& piece)
{
    const double turn = 2 * std::numbers::pi;
    if (!piece.isArc()) return turn * (piece.from_mm.y() + piece.to_mm.y()) / 2 * (piece.to_mm - piece.from_mm).norm();
    const auto [t0, t1] = piece.arcAngles();
    const double radius = std::abs(piece.arc_radius_mm);
    return turn * radius * std::abs(piece.centre_mm().y() * (t1 - t0) + radius * (std::cos(t0) - std::cos(t1)));
}

bool isAcross(const ContourPiece& piece)
{
    return !piece.isArc() && std::abs(piece.to_mm.x() - piece.from_mm.x()) < touching_mm;
}

/// Does the material lie toward the axis?
bool isOutside(const ContourPiece& piece)
{
    return !isAcross(piece) && piece.to_mm.x() > piece.from_mm.x();
}

bool isBore(const ContourPiece& piece)
{
    return !isAcross(piece) && piece.to_mm.x() < piece.from_mm.x();
}

double lowOf(const ContourPiece& piece)
{
    return std::min(piece.from_mm.x(), piece.to_mm.x());
}

double highOf(const ContourPiece& piece)
{
    return std::max(piece.from_mm.x(), piece.to_mm.x());
}

bool endsAt(const ContourPiece& piece, const Vector2d& point)
{
    return (piece.from_mm - point).norm() < touching_mm || (piece.to_mm - point).norm() < touching_mm;
}

/// A piece along the axis that ends at `point`, of those for which `is` holds.
template <class Is>
bool isEndOfAny(const std::vector<MeridianPiece>& pieces, const MeridianPiece& but, const Vector2d& point, Is is)
{
    return std::any_of(pieces.begin(), pieces.end(), [&](const MeridianPiece& other) {
        return &other != &but && is(other.curve) && endsAt(other.curve, point);
    });
}

/// A face across the axis within the material that `other` encloses: the wall or the floor of a cut.
bool isWallOfCut(const std::vector<MeridianPiece>& pieces, const MeridianPiece& wall, const ContourPiece& other)
{
    const double z = wall.curve.from_mm.x();
    if (lowOf(other) > z - touching_mm || highOf(other) < z + touching_mm) return false;
    const auto [low, high] = std::minmax(wall.curve.from_mm.y(), wall.curve.to_mm.y());
    const double radius = other.radiusAt_mm(z);
    if (isBore(other)) return std::abs(radius - low) < touching_mm;
    if (high > radius + touching_mm) return false;
    return !isEndOfAny(pieces, wall, wall.curve.from_mm, isBore) && !isEndOfAny(pieces, wall, wall.curve.to_mm, isBore);
}

/// A surface along the axis beneath `other`, which runs at least as far: the floor of cuts.
bool isBeneath(const ContourPiece& floor, const ContourPiece& other)
{
    if (isOutside(floor) != isOutside(other)) return false;
    if (lowOf(other) > lowOf(floor) + touching_mm || highOf(other) < highOf(floor) - touching_mm) return false;
    const double sense = isOutside(floor) ? 1 : -1;
    for (const double z : {lowOf(floor), (lowOf(floor) + highOf(floor)) / 2, highOf(floor)}) {
        const double within = std::clamp(z, lowOf(other), highOf(other));
        if (sense * (other.radiusAt_mm(within) - floor.radiusAt_mm(z)) < touching_mm) return false;
    }
    return true;
}

bool boundsCut(const std::vector<MeridianPiece>& pieces, const MeridianPiece& piece)
{
    return std::any_of(pieces.begin(), pieces.end(), [&](const MeridianPiece& other) {
        if (&other == &piece || isAcross(other.curve)) return false;
        return isAcross(piece.curve) ? isWallOfCut(pieces, piece, other.curve) : isBeneath(piece.curve, other.curve);
    });
}

/// A bore or a face that leads to no other piece: the ground of a hole, the wall of a slot.
bool isLoose(const std::vector<MeridianPiece>& pieces, const MeridianPiece& piece)
{
    const auto any = [](const ContourPiece&) { return true; };
    return !isOutside(piece.curve) && !isEndOfAny(pieces, piece, piece.curve.from_mm, any) &&
           !isEndOfAny(pieces, piece, piece.curve.to_mm, any) && piece.curve.from_mm.y() > touching_mm &&
           piece.curve.to_mm.y() > touching_mm;
}

void findWhole(std::vector<MeridianPiece>& pieces, const std::vector<StepFace>& faces)
{
    for (MeridianPiece& piece : pieces) {
        double area = 0;
        for (const std::size_t face : piece.faces) area += faces[face].area_mm2;
        piece.whole = area >= wholeTurn * sweptArea_mm2(piece.curve);
    }
}

/// Without the interrupted pieces for which `is_unwanted` holds among all.
template <class Unwanted>
void leaveOut(std::vector<MeridianPiece>& pieces, Unwanted is_unwanted)
{
    std::vector<MeridianPiece> kept;
    for (const MeridianPiece& piece : pieces)
        if (piece.whole || !is_unwanted(pieces, piece)) kept.push_back(piece);
    pieces = std::move(kept);
}

/// The end of a piece across the axis moved to the next edge in that sense, inward without one to the axis.
void extend(const std::vector<MeridianPiece>& pieces, const MeridianPiece& piece, Vector2d& end, bool inward)
{
    const auto isCurved = [](const ContourPiece& other) { return !isAcross(other); };
    if (end.y() < touching_mm || isEndOfAny(pieces, piece, end, isCurved)) return;
    double best = inward ? 0 : end.y();
    for (const MeridianPiece& other : pieces) {
        if (isAcross(other.curve)) continue;
        for (const Vector2d& edge : {other.curve.from_mm, other.curve.to_mm}) {
            if (std::abs(edge.x() - end.x()) > touching_mm) continue;
            if (inward ? edge.y() < end.y() && edge.y() > best
                       : edge.y() > end.y() && (best == end.y() || edge.y() < best))
                best = edge.y();
        }
    }
    end.y() = best;
}

}  // namespace

void keepTurned(std::vector<MeridianPiece>& pieces, const std::vector<StepFace>& faces)
{
    findWhole(pieces, faces);
    leaveOut(pieces, boundsCut);
    leaveOut(pieces, isLoose);
    for (MeridianPiece& piece : pieces) {
        if (piece.whole || !isAcross(piece.curve)) continue;
        const bool outward = piece.curve.to_mm.y() > piece.curve.from_mm.y();
        extend(pieces, piece, outward ? piece.curve.from_mm : piece.curve.to_mm, true);
        extend(pieces, piece, outward ? piece.curve.to_mm : piece.curve.from_mm, false);
    }
}

}  // namespace lathelier::cad
