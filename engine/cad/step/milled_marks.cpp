#include "engine/cad/step/milled_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lathelier::cad {
namespace {

using Eigen::Vector3d;

constexpr double smallShare = 0.2;       ///< of the area of a group, of rounds that do not matter
constexpr double equalSpan_mm = 1e-3;    ///< z of the flats of one hexagon
constexpr double equalFlats_deg = 0.01;  ///< between flats of one hexagon, grooves of one spline
constexpr std::size_t fewestTeeth = 4;

/// A plane along the axis, all its faces; n out of the material, n·p = distance in it.
struct Side {
    Vector3d n = Vector3d::UnitX();
    double distance_mm = 0;
    FaceShapes faces;
    Span z;
};

/// A connected group of faces, sorted by what they may be.
struct Milled {
    FaceShapes all;
    std::vector<Side> sides;
    FaceShapes walls;   ///< planes across the axis
    FaceShapes rounds;  ///< concave cylinders
    FaceShapes rest;    ///< that do matter
    Span z;
    double area_mm2 = 0;
};

void unite(Span& span, const Span& other)
{
    span = {std::min(span.low, other.low), std::max(span.high, other.high)};
}

bool isAboutAxis(const FaceShape& face)
{
    return areParallel(face.axis, Vector3d::UnitZ()) && std::hypot(face.point.x(), face.point.y()) < samePlace_mm;
}

Milled sortedGroup(const FaceShapes& group)
{
    Milled milled;
    milled.all = group;
    milled.z = group.front()->z;
    for (const FaceShape* face : group) {
        unite(milled.z, face->z);
        milled.area_mm2 += face->area_mm2;
    }
    FaceShapes small;
    for (const FaceShape* face : group) {
        if (face->isPlaneAlong()) {
            const double distance = face->axis.dot(face->point);
            const auto side = std::find_if(milled.sides.begin(), milled.sides.end(), [&](const Side& one) {
                return (one.n - face->axis).norm() < alignedAngle &&
                       std::abs(one.distance_mm - distance) < samePlace_mm;
            });
            if (side == milled.sides.end()) {
                milled.sides.push_back({face->axis, distance, {face}, face->z});
            } else {
                side->faces.push_back(face);
                unite(side->z, face->z);
            }
        } else if (face->isPlaneAcross()) {
            milled.walls.push_back(face);
        } else if (face->kind == SurfaceKind::Cylinder && face->concave) {
            milled.rounds.push_back(face);
        } else {
            milled.rest.push_back(face);
        }
    }
    double rest = 0;
    for (const FaceShape* face : milled.rest) {
        const bool is_round = face->kind == SurfaceKind::Cylinder || face->kind == SurfaceKind::Torus ||
                              face->kind == SurfaceKind::Sphere;
        rest += is_round && !isAboutAxis(*face) ? face->area_mm2 : milled.area_mm2;
    }
    if (rest < smallShare * milled.area_mm2) milled.rest.clear();
    return milled;
}

bool areSmallRounds(const FaceShapes& faces, double area_mm2)
{
    double sum = 0;
    for (const FaceShape* face : faces) sum += face->area_mm2;
    return sum < smallShare * area_mm2;
}

HalfSpace halfOf(const Vector3d& n, double distance_mm)
{
    return {n, distance_mm};
}

/// The void on the outer side of a plane of the material.
HalfSpace beyond(const Side& side)
{
    return {-side.n, -side.distance_mm};
}

std::vector<HalfSpace> within(const Span& z)
{
    return {halfOf(Vector3d::UnitZ(), z.high), halfOf(-Vector3d::UnitZ(), -z.low)};
}

ShaftMark over(MarkKind kind, const Span& z)
{
    ShaftMark mark{kind};
    mark.z_start_mm = z.low;
    mark.z_end_mm = z.high;
    return mark;
}

struct Flat {
    ShaftMark mark;
    bool united = false;
};

/// None: not flats.
std::vector<Flat> flatsOf(const Milled& group, std::vector<ConvexCut>& cuts)
{
    std::vector<Flat> flats;
    if (!group.rest.empty() || !areSmallRounds(group.rounds, group.area_mm2)) return flats;
    for (const Side& side : group.sides) {
        if (side.distance_mm < samePlace_mm) return {};
        ShaftMark mark = over(MarkKind::Flat, side.z);
        mark.angle_deg = angleOf_deg(side.n);
        mark.distance_mm = side.distance_mm;
        flats.push_back({mark, false});
    }
    for (const Side& side : group.sides) {
        ConvexCut cut{within(side.z), {}};
        cut.half_spaces.push_back(beyond(side));
        cuts.push_back(std::move(cut));
    }
    return flats;
}

/// Two of the sides that face each other with the void between them.
struct Pair {
    const Side *a = nullptr, *b = nullptr;
    double width_mm = 0;
};

std::optional<Pair> facing(const std::vector<Side>& sides)
{
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size(); ++j) {
            const double width = -(sides[i].distance_mm + sides[j].distance_mm);
            if ((sides[i].n + sides[j].n).norm() < alignedAngle && width > samePlace_mm)
                return Pair{&sides[i], &sides[j], width};
        }
    return {};
}

/// The cuts between two sides: straight ones, and round ends about `direction`.
void addSlotCuts(std::vector<ConvexCut>& cuts, const Pair& pair, const Span& z, const FaceShapes& rounds,
                 const std::vector<HalfSpace>& more)
{
    Span straight = z;
    for (const FaceShape* round : rounds) {
        const double middle = round->point.z();
        (middle < (z.low + z.high) / 2 ? straight.low : straight.high) = middle;
        ConvexCut end{more, {{round->point, round->axis, round->radius_mm, 0}}};
        cuts.push_back(std::move(end));
    }
    ConvexCut cut{within(straight), {}};
    cut.half_spaces.insert(cut.half_spaces.end(), {beyond(*pair.a), beyond(*pair.b)});
    cut.half_spaces.insert(cut.half_spaces.end(), more.begin(), more.end());
    cuts.push_back(std::move(cut));
}

/// Round ends: half circles between the sides about `direction`.
std::optional<FaceShapes> roundEnds(const Milled& group, const Pair& pair, const Vector3d& direction)
{
    FaceShapes ends;
    for (const FaceShape* face : group.rounds) {
        const bool is_end =
            areParallel(face->axis, direction) && std::abs(2 * face->radius_mm - pair.width_mm) < 10 * samePlace_mm;
        if (is_end)
            ends.push_back(face);
        else if (face->area_mm2 > smallShare * group.area_mm2)
            return {};
    }
    return ends.size() <= 2 ? std::optional(ends) : std::nullopt;
}

std::optional<ShaftMark> keywayOf(const Milled& group, const Shaft& turned, std::vector<ConvexCut>& cuts)
{
    if (!group.rest.empty() || group.sides.size() != 3) return {};
    const std::optional<Pair> pair = facing(group.sides);
    if (!pair) return {};
    const Side& floor = *std::find_if(group.sides.begin(), group.sides.end(),
                                      [&](const Side& side) { return &side != pair->a && &side != pair->b; });
    // A floor that faces the axis is that of a keyway in a bore.
    if (!arePerpendicular(floor.n, pair->a->n) || floor.distance_mm < samePlace_mm) return {};
    const std::optional<FaceShapes> ends = roundEnds(group, *pair, floor.n);
    if (!ends) return {};
    ShaftMark mark = over(MarkKind::Keyway, group.z);
    mark.angle_deg = angleOf_deg(floor.n);
    mark.width_mm = pair->width_mm;
    mark.floor_mm = floor.distance_mm;
    mark.depth_mm = outerRadius_mm(turned, (group.z.low + group.z.high) / 2) - floor.distance_mm;
    addSlotCuts(cuts, *pair, group.z, *ends, {beyond(floor)});
    return mark;
}

/// A keyway whose floor is one cylinder across the axis.
std::optional<ShaftMark> woodruffOf(const Milled& group, const Shaft& turned, std::vector<ConvexCut>& cuts)
{
    if (!group.rest.empty() || group.sides.size() != 2 || group.rounds.empty() || !group.walls.empty()) return {};
    const std::optional<Pair> pair = facing(group.sides);
    const FaceShape& floor = *group.rounds.front();
    if (!pair || !areParallel(floor.axis, pair->a->n)) return {};
    for (const FaceShape* face : group.rounds)
        if (std::abs(face->radius_mm - floor.radius_mm) > samePlace_mm ||
            distanceOfLines(face->point, floor.point, floor.axis) > samePlace_mm)
            return {};
    Vector3d u = pair->a->n.cross(Vector3d::UnitZ()).normalized();
    double side = 0;
    for (const Vector3d& point : floor.boundary) side += point.dot(u);
    if (side < 0) u = -u;
    ShaftMark mark = over(MarkKind::Keyway, group.z);
    mark.angle_deg = angleOf_deg(u);
    mark.width_mm = pair->width_mm;
    mark.floor_mm = floor.point.dot(u) - floor.radius_mm;
    mark.depth_mm = outerRadius_mm(turned, floor.point.z()) - *mark.floor_mm;
    cuts.push_back(
        {{beyond(*pair->a), beyond(*pair->b), halfOf(-u, 0)}, {{floor.point, floor.axis, floor.radius_mm, 0}}});
    return mark;
}

std::optional<ShaftMark> slotOf(const Milled& group, std::vector<ConvexCut>& cuts)
{
    if (!group.rest.empty() || group.sides.size() != 2) return {};
    const std::optional<Pair> pair = facing(group.sides);
    if (!pair) return {};
    const Vector3d run = pair->a->n.cross(Vector3d::UnitZ()).normalized();
    const std::optional<FaceShapes> ends = roundEnds(group, *pair, run);
    if (!ends || (ends->empty() && group.walls.empty())) return {};
    for (const Side* side : {pair->a, pair->b}) {  // it crosses the axis
        double low = 0, high = 0;
        for (const FaceShape* face : side->faces) {
            low = std::min(low, spanOf(*face, run).low);
            high = std::max(high, spanOf(*face, run).high);
        }
        if (low > -samePlace_mm || high < samePlace_mm) return {};
    }
    ShaftMark mark = over(MarkKind::Other, group.z);
    mark.other_kind = slotKind;
    mark.angle_deg = restOfTurn_deg(angleOf_deg(run), 180);
    mark.width_mm = pair->width_mm;
    mark.distance_mm = std::abs(pair->a->distance_mm - pair->b->distance_mm) / 2;
    mark.depth_mm = group.z.high - group.z.low;
    addSlotCuts(cuts, *pair, group.z, *ends, {});
    return mark;
}

/// Root of a groove of a spline: its cylinder about the axis; none: no such groove.
const FaceShape* rootOf(const Milled& group)
{
    for (const FaceShape* face : group.all)
        if (face->kind == SurfaceKind::Cylinder && isAboutAxis(*face) && !face->concave) return face;
    return nullptr;
}

bool areEqualGrooves(const Milled& a, const Milled& b)
{
    return a.all.size() == b.all.size() && std::abs(a.area_mm2 - b.area_mm2) < 1e-4 * a.area_mm2 &&
           std::abs(a.z.low - b.z.low) < equalSpan_mm && std::abs(a.z.high - b.z.high) < equalSpan_mm;
}

/// Of equal grooves: their teeth; none: not equally spaced.
std::optional<ShaftMark> splineOf(const std::vector<const Milled*>& grooves, const Shaft& turned)
{
    if (grooves.size() < fewestTeeth) return {};
    std::vector<double> angles;
    double root_mm = 0;
    for (const Milled* groove : grooves) {
        const FaceShape* root = rootOf(*groove);
        if (!root) return {};
        root_mm = root->radius_mm;
        Vector3d middle = Vector3d::Zero();
        for (const Vector3d& point : root->boundary) middle += point;
        angles.push_back(angleOf_deg(middle));
    }
    std::sort(angles.begin(), angles.end());
    const double pitch = 360.0 / static_cast<double>(angles.size());
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        if (std::abs(angles[i + 1] - angles[i] - pitch) > equalFlats_deg) return {};
    const Milled& groove = *grooves.front();
    ShaftMark mark = over(MarkKind::Spline, groove.z);
    mark.teeth = static_cast<double>(angles.size());
    mark.angle_deg = restOfTurn_deg(angles.front() + pitch / 2, pitch);
    mark.major_mm = 2 * outerRadius_mm(turned, (groove.z.low + groove.z.high) / 2);
    mark.minor_mm = 2 * root_mm;
    // Parallel flanks: those of a tooth lie to both sides of the axis.
    if (groove.sides.size() == 2 && std::abs(groove.sides[0].distance_mm - groove.sides[1].distance_mm) < samePlace_mm)
        mark.width_mm = 2 * groove.sides[0].distance_mm;
    return mark;
}

void addSplines(NamedCuts& result, std::vector<Milled> groups, const Shaft& turned)
{
    while (!groups.empty()) {
        const Milled first = groups.front();
        std::vector<const Milled*> grooves;
        for (const Milled& group : groups)
            if (areEqualGrooves(first, group)) grooves.push_back(&group);
        if (const auto mark = splineOf(grooves, turned)) {
            result.marks.push_back(*mark);
            for (const Milled* groove : grooves)
                for (const FaceShape* face : groove->all) result.named[face->number] = true;
        }
        std::erase_if(groups, [&](const Milled& group) { return areEqualGrooves(first, group); });
    }
}

/// Flats of one distance over one stretch, of `count` equal angles: marks them and names the prism.
std::optional<ShaftMark> prismOf(std::vector<Flat>& flats, std::size_t first, std::size_t count, MarkKind kind)
{
    const ShaftMark& one = flats[first].mark;
    const double step = 360.0 / static_cast<double>(count);
    std::vector<std::size_t> found;
    std::size_t equal = 0;  // of any angle: eight are no two squares
    for (std::size_t i = 0; i < flats.size(); ++i) {
        const ShaftMark& other = flats[i].mark;
        const double off = restOfTurn_deg(*other.angle_deg - *one.angle_deg + step / 2, step) - step / 2;
        if (std::abs(*other.distance_mm - *one.distance_mm) > samePlace_mm ||
            std::abs(*other.z_start_mm - *one.z_start_mm) > equalSpan_mm ||
            std::abs(*other.z_end_mm - *one.z_end_mm) > equalSpan_mm)
            continue;
        ++equal;
        if (std::abs(off) < equalFlats_deg) found.push_back(i);
    }
    if (found.size() != count || equal != count) return {};
    ShaftMark mark = over(kind, {*one.z_start_mm, *one.z_end_mm});
    mark.angle_deg = restOfTurn_deg(*one.angle_deg, step);
    mark.across_flats_mm = 2 * *one.distance_mm;
    for (const std::size_t i : found) flats[i].united = true;
    return mark;
}

void addFlats(std::vector<ShaftMark>& marks, std::vector<Flat> flats)
{
    for (std::size_t i = 0; i < flats.size(); ++i) {
        if (flats[i].united) continue;
        std::optional<ShaftMark> prism = prismOf(flats, i, 6, MarkKind::Hexagon);
        if (!prism) prism = prismOf(flats, i, 4, MarkKind::Square);
        marks.push_back(prism ? *prism : flats[i].mark);
    }
}

}  // namespace

NamedCuts milledOf(const std::vector<FaceShape>& faces, std::vector<bool> named, const Shaft& turned)
{
    NamedCuts result;
    result.named = std::move(named);
    FaceShapes left;
    for (const FaceShape& face : faces)
        if (!result.named[face.number]) left.push_back(&face);
    std::vector<Flat> flats;
    std::vector<Milled> others;
    for (const FaceShapes& faces_of : connected(left)) {
        Milled group = sortedGroup(faces_of);
        const std::vector<Flat> found = flatsOf(group, result.cuts);
        std::optional<ShaftMark> mark;
        if (found.empty()) mark = keywayOf(group, turned, result.cuts);
        if (found.empty() && !mark) mark = woodruffOf(group, turned, result.cuts);
        if (found.empty() && !mark) mark = slotOf(group, result.cuts);
        flats.insert(flats.end(), found.begin(), found.end());
        if (mark) result.marks.push_back(*mark);
        if (mark || !found.empty())
            for (const FaceShape* face : faces_of) result.named[face->number] = true;
        else
            others.push_back(std::move(group));
    }
    addFlats(result.marks, std::move(flats));
    addSplines(result, std::move(others), turned);
    return result;
}

}  // namespace lathelier::cad
