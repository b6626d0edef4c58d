#include "engine/gcode/arc.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lathelier::gcode {
namespace {

constexpr double roundingOfChord_mm = 0.01;

Direction unit(double x, double z)
{
    const double length = std::hypot(x, z);
    return length > 0 ? Direction{x / length, z / length} : Direction{};
}

Direction tangent(const Piece& piece, const Point& at)
{
    const Direction out = unit(at.x_mm - piece.centre.x_mm, at.z_mm - piece.centre.z_mm);
    // Counter-clockwise from +Z to +X: the tangent of (z, x) is (-x, z).
    return piece.clockwise ? Direction{-out.z, out.x} : Direction{out.z, -out.x};
}

Point nearer(const Point& a, const Point& b, const Point& near)
{
    return distance_mm(a, near) <= distance_mm(b, near) ? a : b;
}

/// Points of a circle on the line through p with direction d.
std::optional<Point> lineAndCircle(const Point& p, const Direction& d, const Point& centre, double radius,
                                   const Point& near)
{
    const double along = (centre.x_mm - p.x_mm) * d.x + (centre.z_mm - p.z_mm) * d.z;
    const Point foot{p.x_mm + along * d.x, p.z_mm + along * d.z};
    const double away = distance_mm(foot, centre);
    double half2 = radius * radius - away * away;
    if (half2 < -1e-6 * std::max(1.0, radius)) return std::nullopt;
    const double half = std::sqrt(std::max(half2, 0.0));
    return nearer({foot.x_mm + half * d.x, foot.z_mm + half * d.z}, {foot.x_mm - half * d.x, foot.z_mm - half * d.z},
                  near);
}

std::optional<Point> twoCircles(const Point& a, double ra, const Point& b, double rb, const Point& near)
{
    const double d = distance_mm(a, b);
    if (d < 1e-12) return std::nullopt;
    const double along = (d * d + ra * ra - rb * rb) / (2 * d);
    const double half2 = ra * ra - along * along;
    if (half2 < -1e-6 * std::max(1.0, ra)) return std::nullopt;
    const double half = std::sqrt(std::max(half2, 0.0));
    const Direction u = unit(b.x_mm - a.x_mm, b.z_mm - a.z_mm);
    const Point foot{a.x_mm + along * u.x, a.z_mm + along * u.z};
    return nearer({foot.x_mm - half * u.z, foot.z_mm + half * u.x}, {foot.x_mm + half * u.z, foot.z_mm - half * u.x},
                  near);
}

}  // namespace

double distance_mm(const Point& a, const Point& b)
{
    return std::hypot(a.x_mm - b.x_mm, a.z_mm - b.z_mm);
}

std::optional<Point> centreOfRadius(const Point& a, const Point& b, double radius_mm, bool clockwise)
{
    const double chord = distance_mm(a, b);
    const double radius = std::abs(radius_mm);
    if (!(chord > 1e-9) || radius < chord / 2 - roundingOfChord_mm) return std::nullopt;
    const double height = std::sqrt(std::max(radius * radius - chord * chord / 4, 0.0));
    // Left of the chord in (z, x): (-dx, dz). The minor arc counter-clockwise has its centre there.
    const double side = (clockwise ? -1.0 : 1.0) * (radius_mm < 0 ? -1.0 : 1.0);
    const double dz = (b.z_mm - a.z_mm) / chord, dx = (b.x_mm - a.x_mm) / chord;
    return Point{(a.x_mm + b.x_mm) / 2 + side * height * dz, (a.z_mm + b.z_mm) / 2 - side * height * dx};
}

std::optional<Point> centreThrough(const Point& a, const Point& b, const Point& c)
{
    const double bx = b.x_mm - a.x_mm, bz = b.z_mm - a.z_mm, cx = c.x_mm - a.x_mm, cz = c.z_mm - a.z_mm;
    const double twice = 2 * (bx * cz - bz * cx);
    if (std::abs(twice) < 1e-12) return std::nullopt;
    const double b2 = bx * bx + bz * bz, c2 = cx * cx + cz * cz;
    return Point{a.x_mm + (cz * b2 - bz * c2) / twice, a.z_mm + (bx * c2 - cx * b2) / twice};
}

Direction directionAtStart(const Piece& piece)
{
    return piece.isArc() ? tangent(piece, piece.from)
                         : unit(piece.to.x_mm - piece.from.x_mm, piece.to.z_mm - piece.from.z_mm);
}

Direction directionAtEnd(const Piece& piece)
{
    return piece.isArc() ? tangent(piece, piece.to)
                         : unit(piece.to.x_mm - piece.from.x_mm, piece.to.z_mm - piece.from.z_mm);
}

std::optional<Point> meeting(const Piece& a, const Piece& b, const Point& near)
{
    if (a.isArc() && b.isArc()) return twoCircles(a.centre, a.radius_mm(), b.centre, b.radius_mm(), near);
    if (a.isArc()) return lineAndCircle(b.from, directionAtStart(b), a.centre, a.radius_mm(), near);
    if (b.isArc()) return lineAndCircle(a.from, directionAtStart(a), b.centre, b.radius_mm(), near);
    const Direction u = directionAtStart(a), v = directionAtStart(b);
    const double cross = u.z * v.x - u.x * v.z;
    if (std::abs(cross) < 1e-12) return std::nullopt;
    const double along = ((b.from.z_mm - a.from.z_mm) * v.x - (b.from.x_mm - a.from.x_mm) * v.z) / cross;
    return Point{a.from.x_mm + along * u.x, a.from.z_mm + along * u.z};
}

std::optional<Piece> shifted(const Piece& piece, double left_mm)
{
    Piece result = piece;
    if (!piece.isArc()) {
        const Direction d = directionAtStart(piece);
        // Left of the travel (dz, dx) is (-dx, dz).
        for (Point* point : {&result.from, &result.to}) {
            point->z_mm -= left_mm * d.x;
            point->x_mm += left_mm * d.z;
        }
        return result;
    }
    const double radius = piece.radius_mm();
    const double wanted = radius + (piece.clockwise ? left_mm : -left_mm);
    if (!(wanted > 1e-9)) return std::nullopt;
    for (Point* point : {&result.from, &result.to}) {
        const Direction out = unit(point->x_mm - piece.centre.x_mm, point->z_mm - piece.centre.z_mm);
        point->x_mm = piece.centre.x_mm + wanted * out.x;
        point->z_mm = piece.centre.z_mm + wanted * out.z;
    }
    return result;
}

Point nearestOn(const Piece& piece, const Point& point)
{
    if (piece.isArc()) {
        const Direction out = unit(point.x_mm - piece.centre.x_mm, point.z_mm - piece.centre.z_mm);
        return {piece.centre.x_mm + piece.radius_mm() * out.x, piece.centre.z_mm + piece.radius_mm() * out.z};
    }
    const Direction d = directionAtStart(piece);
    const double along = (point.x_mm - piece.from.x_mm) * d.x + (point.z_mm - piece.from.z_mm) * d.z;
    return {piece.from.x_mm + along * d.x, piece.from.z_mm + along * d.z};
}

std::optional<Point> pointAtDistance(const Piece& piece, const Point& end, double distance)
{
    const bool isFrom = distance_mm(end, piece.from) <= distance_mm(end, piece.to);
    const Point other = isFrom ? piece.to : piece.from;
    if (distance_mm(end, other) < distance - 1e-9) return std::nullopt;
    if (piece.isArc()) return twoCircles(piece.centre, piece.radius_mm(), end, distance, other);
    const Direction d = unit(other.x_mm - end.x_mm, other.z_mm - end.z_mm);
    return Point{end.x_mm + distance * d.x, end.z_mm + distance * d.z};
}

}  // namespace lathelier::gcode
