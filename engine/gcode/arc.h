// Arcs of turning: centre and direction from the words of a block. The plane is seen with Z to the right and X upward,
// so G2 runs clockwise. Angles count from +Z towards +X.
#pragma once

#include <optional>

#include "engine/gcode/move.h"

namespace lathelier::gcode {

double distance_mm(const Point& a, const Point& b);

/// Centre of the arc of radius |radius| from a to b; negative: the longer one. If half the chord exceeds the radius by
/// less than 0.01 mm, it is used as the radius. None if the radius is smaller than that, or a equals b.
std::optional<Point> centreOfRadius(const Point& a, const Point& b, double radius_mm, bool clockwise);

/// Centre of the circle through three points; none if they are collinear.
std::optional<Point> centreThrough(const Point& a, const Point& b, const Point& c);

/// A piece of a path; straight if `centre` is unknown.
struct Piece {
    Point from;
    Point to;
    Point centre;
    bool clockwise = false;

    bool isArc() const { return isKnown(centre); }
    double radius_mm() const { return distance_mm(from, centre); }
};

/// A direction as a vector of length 1.
struct Direction {
    double x = 0;
    double z = 0;
};

/// Of travel; zero where a line has no length.
Direction directionAtStart(const Piece& piece);
Direction directionAtEnd(const Piece& piece);

/// Intersection of two pieces extended to full lines or circles; the one nearest to `near`.
std::optional<Point> meeting(const Piece& a, const Piece& b, const Point& near);

/// The piece shifted to the left of its travel (negative: right). None for an arc whose radius would vanish.
std::optional<Piece> shifted(const Piece& piece, double left_mm);

/// Nearest point on the extended piece.
Point nearestOn(const Piece& piece, const Point& point);

/// The point of the piece at a distance from one of its ends; none if the piece is shorter.
std::optional<Point> pointAtDistance(const Piece& piece, const Point& end, double distance);

}  // namespace lathelier::gcode
