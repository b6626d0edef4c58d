#include "engine/cad/step/hole_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector3d;

constexpr double equalHoles_deg = 0.01;  ///< of the holes of a circle

/// A hole in one direction; positions t along it from the point nearest the axis of the part.
struct Hole {
    Vector3d foot = Vector3d::Zero();      ///< on its axis, nearest that of the part; of an axial one at z = 0
    Vector3d outward = Vector3d::UnitZ();  ///< along its axis; of a blind one toward its mouth
    FaceShapes faces;
    double radius_mm = 0;         ///< of its narrowest cylinder
    Span t;                       ///< of its cylinders
    std::optional<double> floor;  ///< t of the end of its cylinder; none: open
    bool both_sides = false;      ///< a cross hole that crosses the axis of the part
};

Span along(const FaceShape& face, const Hole& hole)
{
    const double foot = hole.foot.dot(hole.outward);
    const Span span = spanOf(face, hole.outward);
    return {span.low - foot, span.high - foot};
}

/// Distances of the boundary from the axis of the hole.
Span aroundOf(const FaceShape& face, const Hole& hole)
{
    Span span{0, 0};
    bool first = true;
    for (const Vector3d& point : face.boundary) {
        const double r = distanceOfLines(point, hole.foot, hole.outward);
        span = first ? Span{r, r} : Span{std::min(span.low, r), std::max(span.high, r)};
        first = false;
    }
    return span;
}

bool isOnLine(const FaceShape& face, const Hole& hole, double widest_mm)
{
    switch (face.kind) {
        case SurfaceKind::Cylinder:
            if (!face.concave) return false;
            [[fallthrough]];
        case SurfaceKind::Cone:
        case SurfaceKind::Torus:
            return areParallel(face.axis, hole.outward) &&
                   distanceOfLines(face.point, hole.foot, hole.outward) < samePlace_mm;
        case SurfaceKind::Sphere: return distanceOfLines(face.point, hole.foot, hole.outward) < samePlace_mm;
        case SurfaceKind::Plane:
            return areParallel(face.axis, hole.outward) && aroundOf(face, hole).high < widest_mm + samePlace_mm;
        default: return false;
    }
}

/// Does this face close the hole: a disc, the point of a drill, a sphere?
bool isFloor(const FaceShape& face, const Hole& hole)
{
    const Span around = aroundOf(face, hole);
    if (face.kind == SurfaceKind::Plane) return around.high - around.low < samePlace_mm;
    return face.kind == SurfaceKind::Sphere || (face.kind == SurfaceKind::Cone && around.low < samePlace_mm);
}

/// Its size, its floor and its sense from its faces; none: no cylinder runs all round.
std::optional<Hole> described(Hole hole, bool axial)
{
    FaceShapes cylinders;
    for (const FaceShape* face : hole.faces)
        if (face->kind == SurfaceKind::Cylinder) cylinders.push_back(face);
    if (cylinders.empty()) return {};
    hole.radius_mm = cylinders.front()->radius_mm;
    for (const FaceShape* face : cylinders) hole.radius_mm = std::min(hole.radius_mm, face->radius_mm);
    FaceShapes narrowest;
    for (const FaceShape* face : cylinders)
        if (face->radius_mm < hole.radius_mm + samePlace_mm) narrowest.push_back(face);
    if (!runsAllRound(narrowest, hole.foot, hole.outward)) return {};
    const auto spanOfAll = [&](const FaceShapes& faces) {
        Span span = along(*faces.front(), hole);
        for (const FaceShape* face : faces) {
            const Span one = along(*face, hole);
            span = {std::min(span.low, one.low), std::max(span.high, one.high)};
        }
        return span;
    };
    Span t = spanOfAll(cylinders);
    const auto floor =
        std::find_if(hole.faces.begin(), hole.faces.end(), [&](const FaceShape* face) { return isFloor(*face, hole); });
    const bool is_turned =
        floor != hole.faces.end() ? along(**floor, hole).low > (t.low + t.high) / 2 : !axial && t.low + t.high < 0;
    if (is_turned) {
        hole.outward = -hole.outward;
        t = spanOfAll(cylinders);
    }
    hole.t = t;
    if (floor != hole.faces.end()) hole.floor = spanOfAll(narrowest).low;
    hole.both_sides = !axial && t.low < -samePlace_mm && t.high > samePlace_mm;
    return hole;
}

/// The holes about one line.
std::vector<Hole> holesAbout(const Hole& line, const std::vector<FaceShape>& faces, const std::vector<bool>& named,
                             bool axial)
{
    FaceShapes members;
    double widest = 0;
    for (const FaceShape& face : faces)
        if (!named[face.number] && face.kind == SurfaceKind::Cylinder && isOnLine(face, line, 0))
            widest = std::max(widest, face.radius_mm);
    for (const FaceShape& face : faces)
        if (!named[face.number] && isOnLine(face, line, widest)) members.push_back(&face);
    std::vector<Hole> holes;
    for (FaceShapes& group : connected(members)) {
        Hole hole = line;
        hole.faces = std::move(group);
        if (auto found = described(std::move(hole), axial)) holes.push_back(std::move(*found));
    }
    // Through both walls of a tube: one hole.
    if (!axial && holes.size() == 2 && !holes[0].floor && !holes[1].floor && !holes[0].both_sides &&
        !holes[1].both_sides && holes[0].outward.dot(holes[1].outward) < 0 &&
        std::abs(holes[0].radius_mm - holes[1].radius_mm) < samePlace_mm) {
        holes[0].faces.insert(holes[0].faces.end(), holes[1].faces.begin(), holes[1].faces.end());
        holes[0].both_sides = true;
        holes.pop_back();
    }
    return holes;
}

HalfSpace aboveOf(const Hole& hole, double t)
{
    return {-hole.outward, -(t + hole.foot.dot(hole.outward))};
}

HalfSpace belowOf(const Hole& hole, double t)
{
    return {hole.outward, t + hole.foot.dot(hole.outward)};
}

void addCuts(std::vector<ConvexCut>& cuts, const Hole& hole, bool axial)
{
    const bool through = hole.both_sides && !hole.floor;
    for (const FaceShape* face : hole.faces) {
        const Span t = along(*face, hole);
        if (face->kind == SurfaceKind::Cylinder) {
            ConvexCut cut{{}, {{hole.foot, hole.outward, face->radius_mm, 0}}};
            const bool narrowest = face->radius_mm < hole.radius_mm + samePlace_mm;
            if (axial)
                cut.half_spaces = {aboveOf(hole, t.low), belowOf(hole, t.high)};
            else if (through && !narrowest)
                cut.half_spaces = {t.low + t.high > 0 ? aboveOf(hole, t.low) : belowOf(hole, t.high)};
            else if (!through)
                cut.half_spaces = {aboveOf(hole, hole.floor || !narrowest ? t.low : 0)};
            cuts.push_back(std::move(cut));
        } else if (face->kind == SurfaceKind::Cone) {
            // Its boundary gives the line of radius over t.
            const Vector3d *first = nullptr, *last = nullptr;
            for (const Vector3d& point : face->boundary) {
                if (!first || point.dot(hole.outward) < first->dot(hole.outward)) first = &point;
                if (!last || point.dot(hole.outward) > last->dot(hole.outward)) last = &point;
            }
            if (!first || !(t.high - t.low > samePlace_mm)) continue;
            const double r0 = distanceOfLines(*first, hole.foot, hole.outward),
                         r1 = distanceOfLines(*last, hole.foot, hole.outward);
            const double slope = (r1 - r0) / (t.high - t.low);
            ConvexCut cut{{aboveOf(hole, t.low), belowOf(hole, t.high)},
                          {{hole.foot, hole.outward, r0 - slope * t.low, slope}}};
            cuts.push_back(std::move(cut));
        }
    }
}

ShaftMark crossHole(const Hole& hole, const Shaft& turned)
{
    ShaftMark mark{MarkKind::CrossHole};
    mark.z_start_mm = hole.foot.z() - hole.radius_mm;
    mark.z_end_mm = hole.foot.z() + hole.radius_mm;
    mark.angle_deg = angleOf_deg(hole.outward);
    mark.diameter_mm = 2 * hole.radius_mm;
    const bool through = hole.both_sides && !hole.floor;
    mark.through = through ? 1 : 0;
    if (!through) mark.depth_mm = outerRadius_mm(turned, hole.foot.z()) - hole.floor.value_or(hole.t.low);
    return mark;
}

/// Of one size, from one place.
bool areOfOneCircle(const Hole& a, const Hole& b)
{
    return std::abs(a.radius_mm - b.radius_mm) < samePlace_mm &&
           std::abs(a.foot.norm() - b.foot.norm()) < samePlace_mm && a.outward.dot(b.outward) > 0 &&
           std::abs(a.t.low - b.t.low) < samePlace_mm && std::abs(a.t.high - b.t.high) < samePlace_mm &&
           a.floor.has_value() == b.floor.has_value();
}

ShaftMark boltCircle(const Hole& hole, std::size_t count)
{
    ShaftMark mark{MarkKind::BoltCircle};
    const double z0 = hole.t.low * hole.outward.z(), z1 = hole.t.high * hole.outward.z();
    mark.z_start_mm = std::min(z0, z1);
    mark.z_end_mm = std::max(z0, z1);
    mark.angle_deg = angleOf_deg(hole.foot);
    mark.diameter_mm = 2 * hole.radius_mm;
    mark.count = static_cast<double>(count);
    mark.pitch_circle_mm = 2 * hole.foot.norm();
    mark.through = hole.floor ? 0 : 1;
    if (hole.floor) mark.depth_mm = hole.t.high - *hole.floor;
    return mark;
}

void addBoltCircles(std::vector<ShaftMark>& marks, std::vector<Hole> holes)
{
    while (!holes.empty()) {
        const Hole first = holes.front();
        std::vector<Hole> ring;
        for (const Hole& hole : holes)
            if (areOfOneCircle(first, hole)) ring.push_back(hole);
        std::erase_if(holes, [&](const Hole& hole) { return areOfOneCircle(first, hole); });
        std::sort(ring.begin(), ring.end(),
                  [](const Hole& a, const Hole& b) { return angleOf_deg(a.foot) < angleOf_deg(b.foot); });
        bool equal = true;
        for (std::size_t i = 0; i + 1 < ring.size(); ++i)
            equal &= std::abs(angleOf_deg(ring[i + 1].foot) - angleOf_deg(ring[i].foot) -
                              360.0 / static_cast<double>(ring.size())) < equalHoles_deg;
        if (equal)
            marks.push_back(boltCircle(ring.front(), ring.size()));
        else
            for (const Hole& hole : ring) marks.push_back(boltCircle(hole, 1));
    }
}

/// The line of a concave cylinder as that of a hole; none: neither across the axis nor beside it.
std::optional<Hole> lineOf(const FaceShape& face)
{
    Hole line;
    line.outward = face.axis;
    if (areParallel(face.axis, Vector3d::UnitZ())) {
        line.outward = Vector3d::UnitZ();
        line.foot = face.point - face.point.z() * Vector3d::UnitZ();
        return line.foot.norm() > samePlace_mm ? std::optional(line) : std::nullopt;
    }
    if (!arePerpendicular(face.axis, Vector3d::UnitZ())) return {};
    const Vector3d foot = face.point - face.point.dot(face.axis) * face.axis;
    if (std::hypot(foot.x(), foot.y()) > samePlace_mm) return {};
    line.foot = {0, 0, foot.z()};
    return line;
}

}  // namespace

double outerRadius_mm(const Shaft& turned, double z_mm)
{
    double radius = 0;
    for (const ContourPiece& piece : outerContour(turned)) {
        const auto [low, high] = std::minmax(piece.from_mm.x(), piece.to_mm.x());
        if (z_mm < low - samePlace_mm || z_mm > high + samePlace_mm) continue;
        radius = std::max(radius, high - low < samePlace_mm ? std::max(piece.from_mm.y(), piece.to_mm.y())
                                                            : piece.radiusAt_mm(std::clamp(z_mm, low, high)));
    }
    return radius;
}

NamedCuts holesOf(const std::vector<FaceShape>& faces, const Shaft& turned)
{
    NamedCuts result;
    result.named.assign(faces.size(), false);
    std::vector<Hole> axial_holes;
    for (const FaceShape& face : faces) {
        if (face.kind != SurfaceKind::Cylinder || !face.concave || result.named[face.number]) continue;
        const std::optional<Hole> line = lineOf(face);
        if (!line) continue;
        const bool axial = areParallel(line->outward, Vector3d::UnitZ());
        for (Hole& hole : holesAbout(*line, faces, result.named, axial)) {
            for (const FaceShape* one : hole.faces) result.named[one->number] = true;
            addCuts(result.cuts, hole, axial);
            if (axial)
                axial_holes.push_back(std::move(hole));
            else
                result.marks.push_back(crossHole(hole, turned));
        }
    }
    addBoltCircles(result.marks, std::move(axial_holes));
    return result;
}

}  // namespace lathelier::cad
