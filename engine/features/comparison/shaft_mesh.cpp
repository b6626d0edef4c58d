#include "engine/features/comparison/shaft_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/shaft/shaft_contour.h"

namespace lathelier::features {
namespace {

using Eigen::Vector2d;

/// Radius for the inner points of an arc's chords, so that they enclose its area; the ends stay where they are.
double innerRadius_mm(double radius_mm, double step, int chords)
{
    const double a = (chords - 2) * std::sin(step) / 2, b = radius_mm * std::sin(step);
    const double c = -radius_mm * radius_mm * chords * step / 2;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

/// How many equal chords of an arc of this angle stay within the sagitta.
int chordsOf(double angle, double radius_mm, double sagitta_mm)
{
    const double step = 2 * std::acos(1 - std::min(1.0, sagitta_mm / radius_mm));
    return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
}

/// The contour as a closed polygon (z, r), the last point before the first.
std::vector<Vector2d> polygonOf(const Contour& contour, double sagitta_mm)
{
    std::vector<Vector2d> points;
    for (const ContourPiece& piece : contour) {
        points.push_back(piece.from_mm);
        if (!piece.isArc()) continue;
        const Vector2d centre = piece.centre_mm();
        const auto [start, end] = piece.arcAngles();
        const double radius = std::abs(piece.arc_radius_mm);
        const int chords = std::max(meshingLimits.least_chords, chordsOf(end - start, radius, sagitta_mm));
        const double inner = innerRadius_mm(radius, std::abs(end - start) / chords, chords);
        for (int i = 1; i < chords; ++i) {
            const double angle = start + (end - start) * i / chords;
            points.push_back(centre + inner * Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    return points;
}

int sidesFor(const std::vector<Vector2d>& polygon, double sagitta_mm)
{
    double largest = 0;
    for (const Vector2d& point : polygon) largest = std::max(largest, point.y());
    return largest > 0 ? std::max(meshingLimits.least_sides, chordsOf(2 * std::numbers::pi, largest, sagitta_mm))
                       : meshingLimits.least_sides;
}

/// The vertices of one point of the meridian: a ring, or a single one on the axis.
struct Ring {
    std::uint32_t first = 0;
    bool on_axis = false;
    std::uint32_t at(int side, int sides) const
    {
        return on_axis ? first : first + static_cast<std::uint32_t>(side % sides);
    }
};

}  // namespace

ShaftMesh shaftMesh(const Shaft& shaft, double sagitta_mm, const Progress& progress)
{
    ShaftMesh made;
    made.sagitta_mm = sagitta_mm;
    const Contour contour = closedContour(shaft);
    std::vector<Vector2d> polygon = polygonOf(contour, sagitta_mm);
    int sides = sidesFor(polygon, sagitta_mm);
    while (2 * polygon.size() * static_cast<std::size_t>(sides) > meshingLimits.most_triangles &&
           sides > meshingLimits.least_sides) {
        made.sagitta_mm *= meshingLimits.coarsening;
        polygon = polygonOf(contour, made.sagitta_mm);
        sides = sidesFor(polygon, made.sagitta_mm);
    }
    const double turn = 2 * std::numbers::pi / sides;
    const double outward = std::sqrt(turn / std::sin(turn));  // area of the polygon = area of the circle
    std::vector<Ring> rings;
    auto& points = made.scan.points_mm;
    for (const Vector2d& point : polygon) {
        progress.check();
        Ring ring{static_cast<std::uint32_t>(points.size()), point.y() <= meshingLimits.no_radius_mm};
        const double radius = ring.on_axis ? 0 : point.y() * outward;
        for (int side = 0; side < (ring.on_axis ? 1 : sides); ++side)
            points.emplace_back(radius * std::cos(turn * side), radius * std::sin(turn * side), point.x());
        rings.push_back(ring);
    }
    for (std::size_t i = 0; i < rings.size(); ++i) {
        progress.check();
        const Ring &from = rings[i], &to = rings[(i + 1) % rings.size()];
        if (from.on_axis && to.on_axis) continue;
        for (int side = 0; side < sides; ++side) {  // the material lies to the right of the contour
            const std::uint32_t a = from.at(side, sides), b = from.at(side + 1, sides);
            const std::uint32_t c = to.at(side, sides), d = to.at(side + 1, sides);
            if (!from.on_axis) made.scan.triangles.push_back({a, b, d});
            if (!to.on_axis) made.scan.triangles.push_back({a, d, c});
        }
    }
    return made;
}

}  // namespace lathelier::features
