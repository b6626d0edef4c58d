// Convex polygons in the meridian plane: outlines of tools and machine parts, and what they sweep on a straight move.
// z runs to the right, x (a radius) upward.
#pragma once

#include <vector>

namespace lathelier::stock {

/// A point of the meridian plane, or a displacement in it.
struct Corner {
    double z_mm = 0;  ///< along the axis
    double x_mm = 0;  ///< radius; below zero beyond the axis
    friend bool operator==(const Corner&, const Corner&) = default;
};

inline Corner operator+(const Corner& a, const Corner& b)
{
    return {a.z_mm + b.z_mm, a.x_mm + b.x_mm};
}

inline Corner operator-(const Corner& a, const Corner& b)
{
    return {a.z_mm - b.z_mm, a.x_mm - b.x_mm};
}

inline Corner operator*(double factor, const Corner& a)
{
    return {factor * a.z_mm, factor * a.x_mm};
}

/// Twice the area of the triangle that both span: above 0 where `b` lies to the left of `a`.
inline double cross(const Corner& a, const Corner& b)
{
    return a.z_mm * b.x_mm - a.x_mm * b.z_mm;
}

double length_mm(const Corner& displacement);

/// Corners anticlockwise. Fewer than three: empty. Corners on a straight edge are allowed.
using ConvexPolygon = std::vector<Corner>;

/// The smallest rectangle along the axes around a polygon; of size zero if the polygon is empty.
struct Box {
    Corner low, high;
};
Box boxOf(const ConvexPolygon& polygon);

/// Convex hull (monotone chain; A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979).
ConvexPolygon hullOf(std::vector<Corner> corners);

ConvexPolygon movedBy(const ConvexPolygon& polygon, const Corner& by);

/// Region swept by the polygon during a displacement `by`: the hull of its first and last placement, which is its
/// Minkowski sum with the displacement. Edges facing the displacement are moved, the others kept: no intersection is
/// computed, so no input is degenerate. O(corners).
ConvexPolygon sweptBy(const ConvexPolygon& polygon, const Corner& by);

/// Minkowski sum with the regular octagon around the circle of radius `distance_mm`: an offset by that distance, up to
/// 8 % more at corners.
ConvexPolygon grownBy(const ConvexPolygon& polygon, double distance_mm);

/// Inward offset by `distance_mm`; may be empty. O(corners²).
ConvexPolygon shrunkBy(const ConvexPolygon& polygon, double distance_mm);

/// Intersection of two polygons (I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", 1974).
ConvexPolygon overlapOf(const ConvexPolygon& a, const ConvexPolygon& b);

}  // namespace lathelier::stock
