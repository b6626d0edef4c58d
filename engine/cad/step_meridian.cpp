#include "engine/cad/step_meridian.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/cad/step/meridian_pieces.h"
#include "engine/core/units.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double sameAngle = 1e-6;     ///< angle between equal axes, rad
constexpr double sameAxis_mm = 1e-4;   ///< distance of equal axes
constexpr double sameCurve_mm = 1e-6;  ///< distance of pieces of one line or circle
constexpr double sameEnd_mm = 1e-4;    ///< distance of coincident ends
constexpr double beyondVertex_mm = 1e-6;
constexpr double noArc = 1e-7;  ///< rad

using Piece = MeridianPiece;

bool isAbout(const StepFace& face, const Line3& axis)
{
    if (face.kind == SurfaceKind::Other) return false;
    const Vector3d to_inner = face.inner_mm - axis.point_mm;
    if (face.kind == SurfaceKind::Sphere) return axis.meridianOf(face.axis_point_mm).y() < sameAxis_mm;
    if (face.axis.cross(axis.direction).norm() > sameAngle) return false;
    if (face.kind == SurfaceKind::Plane) return true;
    // Reference point near the face: the axis point in the file may be far away.
    const double along =
        (axis.point_mm + to_inner.dot(axis.direction) * axis.direction - face.axis_point_mm).dot(face.axis);
    return axis.meridianOf(face.axis_point_mm + along * face.axis).y() < sameAxis_mm;
}

/// Vertices, and edge points only beyond the vertices.
std::vector<Vector2d> boundaryOf(const StepFace& face, const Line3& axis)
{
    std::vector<Vector2d> points;
    Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vector3d& vertex : face.vertices_mm) {
        points.push_back(axis.meridianOf(vertex));
        low = low.cwiseMin(points.back());
        high = high.cwiseMax(points.back());
    }
    for (const auto& edge : face.edges_mm)
        for (const Vector3d& sample : edge) {
            const Vector2d point = axis.meridianOf(sample);
            if ((point.array() < low.array() - beyondVertex_mm).any() ||
                (point.array() > high.array() + beyondVertex_mm).any())
                points.push_back(point);
        }
    return points;
}

/// True if the axis intersects a plane face: a ray from the axis crosses an odd number of edges.
bool holdsAxis(const StepFace& face, const Line3& axis)
{
    const Vector3d u = axis.direction.unitOrthogonal(), v = axis.direction.cross(u);
    bool inside = false;
    for (const auto& edge : face.edges_mm)
        for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
            const Vector3d a = edge[i] - axis.point_mm, b = edge[i + 1] - axis.point_mm;
            const double ya = a.dot(v), yb = b.dot(v);
            if ((ya > 0) == (yb > 0)) continue;
            if (a.dot(u) + (b.dot(u) - a.dot(u)) * ya / (ya - yb) > 0) inside = !inside;
        }
    return inside;
}

std::optional<ContourPiece> straightPiece(const StepFace& face, const Line3& axis, const Vector2d& travel)
{
    std::vector<Vector2d> points = boundaryOf(face, axis);
    if (points.empty()) return {};
    if (face.kind == SurfaceKind::Cylinder)
        for (Vector2d& point : points) point.y() = face.radius_mm;
    if (face.kind == SurfaceKind::Plane) {
        const double z = axis.meridianOf(face.axis_point_mm).x();
        for (Vector2d& point : points) point.x() = z;
        if (holdsAxis(face, axis)) points.emplace_back(z, 0);
    }
    const auto byZ = [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); };
    const auto byR = [](const Vector2d& a, const Vector2d& b) { return a.y() < b.y(); };
    auto [low, high] = std::minmax_element(points.begin(), points.end(), byZ);
    if (high->x() - low->x() < sameCurve_mm)
        std::tie(low, high) = std::minmax_element(points.begin(), points.end(), byR);
    ContourPiece piece{*low, *high, 0};
    if ((piece.to_mm - piece.from_mm).norm() < sameCurve_mm) return {};
    return (piece.to_mm - piece.from_mm).dot(travel) < 0 ? piece.reversed() : piece;
}

/// One or two arcs: more than half a turn is cut in the middle.
std::vector<ContourPiece> arcs(const StepFace& face, const Line3& axis, const Vector2d& outward)
{
    Vector2d centre = axis.meridianOf(face.circle_centre_mm);
    const Vector3d inner_radial = face.inner_mm - axis.point_mm;
    const Vector3d centre_radial = face.circle_centre_mm - axis.point_mm;
    const auto across = [&](const Vector3d& v) -> Vector3d { return v - v.dot(axis.direction) * axis.direction; };
    if (across(inner_radial).dot(across(centre_radial)) < 0) centre.y() = -centre.y();
    const Vector2d inner = axis.meridianOf(face.inner_mm);
    const double middle = std::atan2(inner.y() - centre.y(), inner.x() - centre.x());
    double low = 0, high = 0;
    Vector2d low_end = inner, high_end = inner;
    for (const Vector2d& point : boundaryOf(face, axis)) {
        const double off = std::remainder(std::atan2(point.y() - centre.y(), point.x() - centre.x()) - middle, 2 * pi);
        if (off < low) low = off, low_end = point;
        if (off > high) high = off, high_end = point;
    }
    if (high - low < noArc) return {};
    const bool convex =
        outward.dot(inner - centre) > 0;  // the material is on the right, as is the centre of a convex arc
    const double radius = convex ? face.radius_mm : -face.radius_mm;
    const auto directed = [&](const Vector2d& a, const Vector2d& b) {  // a before b in the sense of the angle
        return convex ? ContourPiece{b, a, radius} : ContourPiece{a, b, radius};
    };
    if (high - low <= pi * (1 + 1e-9)) return {directed(low_end, high_end)};
    const double half = middle + (low + high) / 2;
    const Vector2d cut = centre + face.radius_mm * Vector2d(std::cos(half), std::sin(half));
    return {directed(low_end, cut), directed(cut, high_end)};
}

std::vector<Piece> piecesOf(const StepFace& face, std::size_t number, const Line3& axis)
{
    const Vector3d d = face.inner_mm - axis.point_mm;
    const Vector3d radial = (d - d.dot(axis.direction) * axis.direction).normalized();
    const Vector2d outward(face.outward.dot(axis.direction), face.outward.dot(radial));
    std::vector<Piece> pieces;
    if (face.kind == SurfaceKind::Torus || face.kind == SurfaceKind::Sphere || face.kind == SurfaceKind::RevolvedArc) {
        for (const ContourPiece& arc : arcs(face, axis, outward)) pieces.push_back({arc, false, {number}});
    } else if (const auto line = straightPiece(face, axis, {outward.y(), -outward.x()})) {
        pieces.push_back({*line, face.kind == SurfaceKind::Cylinder, {number}});
    }
    return pieces;
}

std::optional<ContourPiece> unitedLines(const ContourPiece& a, const ContourPiece& b)
{
    const Vector2d run = a.to_mm - a.from_mm;
    const double length = run.norm();
    const Vector2d along = run / length, left(-along.y(), along.x());
    if ((b.to_mm - b.from_mm).dot(along) <= 0) return {};
    for (const Vector2d& end : {b.from_mm, b.to_mm})
        if (std::abs((end - a.from_mm).dot(left)) > sameCurve_mm) return {};
    const double begin = (b.from_mm - a.from_mm).dot(along), end = (b.to_mm - a.from_mm).dot(along);
    if (begin > length + sameEnd_mm || end < -sameEnd_mm) return {};
    return ContourPiece{begin < 0 ? b.from_mm : a.from_mm, end > length ? b.to_mm : a.to_mm, 0};
}

std::optional<ContourPiece> unitedArcs(const ContourPiece& a, const ContourPiece& b)
{
    if (std::abs(a.arc_radius_mm - b.arc_radius_mm) > sameCurve_mm) return {};
    if ((a.centre_mm() - b.centre_mm()).norm() > sameCurve_mm) return {};
    const auto [a0, a1] = a.arcAngles();
    const auto [b0, b1] = b.arcAngles();
    const double sense = a1 > a0 ? 1 : -1;
    const double begin = sense * std::remainder(b0 - a0, 2 * pi), end = begin + std::abs(b1 - b0);
    const double length = std::abs(a1 - a0);
    const double overlap = std::min(length, end) - std::max(0.0, begin);
    const double whole = std::max(length, end) - std::min(0.0, begin);
    // Two arcs that meet at their circle's largest or least diameter remain two rows, so that the diameter appears in
    // the table.
    const Vector2d joint = begin > 0 ? a.to_mm : a.from_mm;
    if (overlap < noArc && std::abs(joint.x() - a.centre_mm().x()) < sameCurve_mm) return {};
    if (overlap < -noArc || whole > pi * (1 + 1e-9) || (overlap < noArc && whole > pi * (1 - 1e-6))) return {};
    return ContourPiece{begin < 0 ? b.from_mm : a.from_mm, end > length ? b.to_mm : a.to_mm, a.arc_radius_mm};
}

std::optional<ContourPiece> united(const ContourPiece& a, const ContourPiece& b)
{
    if (a.isArc() != b.isArc()) return {};
    return a.isArc() ? unitedArcs(a, b) : unitedLines(a, b);
}

void merge(std::vector<Piece>& pieces, Piece piece)
{
    for (std::size_t i = 0; i < pieces.size();) {
        const auto both = united(pieces[i].curve, piece.curve);
        if (!both) {
            ++i;
            continue;
        }
        piece.curve = *both;
        piece.faces.insert(piece.faces.end(), pieces[i].faces.begin(), pieces[i].faces.end());
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
    }
    pieces.push_back(std::move(piece));
}

bool startsOnAxis(const Piece& piece)
{
    return piece.curve.from_mm.y() < same_mm;
}

/// The piece to begin with: from the axis at the least z, else the outermost.
std::size_t firstOf(const std::vector<Piece>& pieces)
{
    std::size_t first = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const Piece &a = pieces[i], &b = pieces[first];
        const bool on_axis = startsOnAxis(a);
        if (on_axis != startsOnAxis(b) ? on_axis
            : on_axis                  ? a.curve.from_mm.x() < b.curve.from_mm.x()
                                       : a.curve.from_mm.y() > b.curve.from_mm.y())
            first = i;
    }
    return first;
}

/// The piece that starts at `end`; none: the contour is closed.
std::optional<std::size_t> following(const std::vector<Piece>& pieces, const std::vector<bool>& used,
                                     const Vector2d& end, const Piece& first)
{
    std::optional<std::size_t> best;
    if (end.y() < same_mm) {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (!used[i] && startsOnAxis(pieces[i]) && pieces[i].curve.from_mm.x() <= end.x() + same_mm &&
                (!best || pieces[i].curve.from_mm.x() > pieces[*best].curve.from_mm.x()))
                best = i;
        return best;
    }
    double least = startsOnAxis(first) ? std::numeric_limits<double>::infinity() : (first.curve.from_mm - end).norm();
    if (least < sameEnd_mm) return {};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double distance = (pieces[i].curve.from_mm - end).norm();
        if (!used[i] && distance < least) least = distance, best = i;
    }
    return best;
}

/// Makes `next` begin where `piece` ends: at the radius of whichever is a cylinder.
void join(Piece& piece, Piece& next)
{
    if (next.cylinder && !piece.cylinder) piece.curve.to_mm.y() = next.curve.from_mm.y();
    next.curve.from_mm = piece.curve.to_mm;
    if (next.cylinder) next.curve.to_mm.y() = next.curve.from_mm.y();
}

}  // namespace

Vector2d Line3::meridianOf(const Vector3d& point) const
{
    const Vector3d d = point - point_mm;
    const double z = d.dot(direction);
    return {z, (d - z * direction).norm()};
}

std::optional<Line3> commonAxis(const std::vector<StepFace>& faces)
{
    struct Group {
        Line3 axis;
        double area_mm2 = 0;
    };
    std::vector<Group> groups;
    for (const bool spheres : {false, true}) {
        for (const StepFace& face : faces) {
            const bool sphere = face.kind == SurfaceKind::Sphere;
            if (face.kind == SurfaceKind::Plane || face.kind == SurfaceKind::Other || sphere != spheres) continue;
            const auto group =
                std::find_if(groups.begin(), groups.end(), [&](const Group& one) { return isAbout(face, one.axis); });
            if (group == groups.end())
                groups.push_back({{face.axis_point_mm, face.axis}, face.area_mm2});
            else
                group->area_mm2 += face.area_mm2;
        }
        if (!groups.empty()) break;
    }
    if (groups.empty()) return {};
    Line3 axis = std::max_element(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
                     return a.area_mm2 < b.area_mm2;
                 })->axis;
    Eigen::Index largest = 0;
    axis.direction.cwiseAbs().maxCoeff(&largest);
    if (axis.direction[largest] < 0) axis.direction = -axis.direction;
    return axis;
}

Meridian meridianOf(const std::vector<StepFace>& faces, const Line3& axis, const Progress& progress)
{
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        progress.check();
        if (!isAbout(faces[i], axis)) continue;
        for (Piece& piece : piecesOf(faces[i], i, axis)) merge(pieces, std::move(piece));
    }
    keepTurned(pieces, faces);
    Meridian result;
    std::vector<bool> taken(faces.size()), used(pieces.size());
    std::vector<Piece> chain;
    if (!pieces.empty()) {
        const Piece first = pieces[firstOf(pieces)];
        for (std::optional<std::size_t> at = firstOf(pieces); at;) {
            progress.check();
            used[*at] = true;
            for (const std::size_t face : pieces[*at].faces) taken[face] = true;
            Piece next = pieces[*at];
            if (!chain.empty() && chain.back().curve.to_mm.y() >= same_mm) {
                const ContourPiece gap{chain.back().curve.to_mm, next.curve.from_mm, 0};
                if ((gap.to_mm - gap.from_mm).norm() > sameEnd_mm) {
                    chain.push_back({gap, false, {}});
                    result.gaps.push_back(gap);
                } else {
                    join(chain.back(), next);
                }
            }
            chain.push_back(next);
            at = following(pieces, used, next.curve.to_mm, first);
        }
    }
    for (const Piece& piece : chain) result.closed.push_back(piece.curve);
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (!taken[i]) result.other_faces.push_back(i);
    return result;
}

}  // namespace lathelier::cad
