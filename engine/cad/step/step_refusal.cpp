#include "engine/cad/step/step_refusal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/cad/step/face_shape.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t worstFaces = 4;           ///< largest number of faces named in an error
constexpr std::size_t prismaticDirections = 6;  ///< of planes; a faceted cylinder has more
constexpr double moreThanHalf = 1.05;           ///< of half a turn: the round of an edge or a lug is no eccentric

const Text notRound = LT_TEXT("Engine", "its sections are not round");
const Text noSingleAxis = LT_TEXT("Engine", "no single axis fits");
const Text freeForm = LT_TEXT("Engine",
                              "its faces are free-form surfaces that are exactly no plane, cylinder, cone, sphere or "
                              "torus");
const Text faceted = LT_TEXT("Engine", "all its faces are planes");
const Text prismatic = LT_TEXT("Engine", "it is prismatic; planes along the axis bound it");
const Text eccentric = LT_TEXT("Engine", "part of its outside is eccentric, a cylinder beside the axis");

Text nameOf(SurfaceKind kind)
{
    switch (kind) {
        case SurfaceKind::Plane: return LT_TEXT("Engine", "plane");
        case SurfaceKind::Cylinder: return LT_TEXT("Engine", "cylinder");
        case SurfaceKind::Cone: return LT_TEXT("Engine", "cone");
        case SurfaceKind::Torus: return LT_TEXT("Engine", "torus");
        case SurfaceKind::Sphere: return LT_TEXT("Engine", "sphere");
        case SurfaceKind::RevolvedLine:
        case SurfaceKind::RevolvedArc: return LT_TEXT("Engine", "surface of revolution");
        case SurfaceKind::Other: return LT_TEXT("Engine", "free-form surface");
    }
    return {};
}

/// Through the middle of the part along its longest side, for the description of a part without an axis.
Line3 longestSide(const std::vector<StepFace>& faces)
{
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const StepFace& face : faces)
        for (const Vector3d& vertex : face.vertices_mm) {
            low = low.cwiseMin(vertex);
            high = high.cwiseMax(vertex);
        }
    if (!low.allFinite() || !high.allFinite()) return {};
    Eigen::Index longest = 0;
    (high - low).maxCoeff(&longest);
    return {(low + high) / 2, Vector3d::Unit(longest)};
}

std::vector<std::size_t> everyFace(const StepSolid& solid)
{
    std::vector<std::size_t> all(solid.faces.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

[[noreturn]] void refusePart(const StepSolid& solid, const std::vector<std::size_t>& which, const Line3& axis,
                             const char* reason, Text why, double residual_mm)
{
    Rows faces;
    for (const OtherFace& face : describeFaces(solid, which, axis, 0)) {
        if (faces.rows.size() == worstFaces) break;
        faces.rows.push_back({{{"kind", face.kind}, {"area_mm2", face.area_mm2}}});
    }
    throw Error(errors::notABodyOfRevolution, {{"role", std::string("part")},
                                               {"reason", std::string(reason)},
                                               {"why", why},
                                               {"residual_mm", residual_mm},
                                               {"faces", faces}});
}

/// Largest difference of the radii of a face.
double unevenness_mm(const StepSolid& solid, const std::vector<std::size_t>& which, const Line3& axis)
{
    double largest = 0;
    for (const std::size_t i : which) {
        const FaceExtent extent = extentOf(solid.faces[i], axis);
        largest = std::max(largest, extent.r_high - extent.r_low);
    }
    return largest;
}

/// Distance of its axis from that of the part; 0: no eccentric round.
double offsetOf_mm(const StepFace& face, const Line3& axis)
{
    if (face.kind != SurfaceKind::Cylinder || !areParallel(face.axis, axis.direction)) return 0;
    const Vector3d from = face.inner_mm - face.axis_point_mm;
    if (face.outward.dot(from - from.dot(face.axis) * face.axis) <= 0) return 0;
    const FaceExtent extent = extentOf(face, axis);
    if (face.area_mm2 < moreThanHalf * std::numbers::pi * face.radius_mm * (extent.z_high - extent.z_low)) return 0;
    const double offset = axis.meridianOf(face.axis_point_mm).y();
    return offset > samePlace_mm ? offset : 0;
}

/// Whether most of the surface that is not plane is free-form.
bool isFreeForm(const std::vector<StepFace>& faces)
{
    double free_mm2 = 0, curved_mm2 = 0;
    for (const StepFace& face : faces) {
        if (face.kind != SurfaceKind::Plane) curved_mm2 += face.area_mm2;
        if (face.kind == SurfaceKind::Other) free_mm2 += face.area_mm2;
    }
    return 2 * free_mm2 > curved_mm2;
}

bool isTurnedOutside(const StepFace& face, const Line3& axis)
{
    const Vector3d from = face.inner_mm - axis.point_mm;
    return face.outward.dot(from - from.dot(axis.direction) * axis.direction) > 0;
}

}  // namespace

FaceExtent extentOf(const StepFace& face, const Line3& axis)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    FaceExtent extent{infinite, -infinite, infinite, -infinite};
    const auto add = [&](const Vector3d& point) {
        const Vector2d zr = axis.meridianOf(point);
        extent = {std::min(extent.z_low, zr.x()), std::max(extent.z_high, zr.x()), std::min(extent.r_low, zr.y()),
                  std::max(extent.r_high, zr.y())};
    };
    for (const Vector3d& vertex : face.vertices_mm) add(vertex);
    for (const auto& edge : face.edges_mm)
        for (const Vector3d& point : edge) add(point);
    if (extent.z_low > extent.z_high) add(face.inner_mm);
    return extent;
}

std::vector<OtherFace> describeFaces(const StepSolid& solid, const std::vector<std::size_t>& which, const Line3& axis,
                                     double free_end_mm)
{
    std::vector<OtherFace> result;
    for (const std::size_t i : which) {
        const FaceExtent extent = extentOf(solid.faces[i], axis);
        result.push_back({nameOf(solid.faces[i].kind), solid.faces[i].area_mm2, extent.z_low - free_end_mm,
                          extent.z_high - free_end_mm});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const OtherFace& a, const OtherFace& b) { return a.area_mm2 > b.area_mm2; });
    return result;
}

void refusePlanes(const StepSolid& solid)
{
    std::vector<Vector3d> directions;
    for (const StepFace& face : solid.faces) {
        if (face.kind != SurfaceKind::Plane) return;
        if (std::none_of(directions.begin(), directions.end(),
                         [&](const Vector3d& one) { return areParallel(one, face.axis); }))
            directions.push_back(face.axis);
    }
    const Line3 axis = longestSide(solid.faces);
    const auto all = everyFace(solid);
    const bool is_prism = directions.size() <= prismaticDirections;
    refusePart(solid, all, axis, is_prism ? "prismatic" : "faceted", is_prism ? prismatic : faceted,
               unevenness_mm(solid, all, axis));
}

void refuseWithoutAxis(const StepSolid& solid)
{
    const Line3 axis = longestSide(solid.faces);
    const auto all = everyFace(solid);
    const bool is_free = isFreeForm(solid.faces);
    refusePart(solid, all, axis, is_free ? "free_form" : "no_single_axis", is_free ? freeForm : noSingleAxis,
               unevenness_mm(solid, all, axis));
}

void refuseSolid(const StepSolid& solid, const Meridian& meridian, const Line3& axis)
{
    const std::vector<std::size_t>& others = meridian.other_faces;
    std::vector<bool> is_other(solid.faces.size());
    std::vector<std::size_t> eccentrics, planes;
    double offset_mm = 0, planes_mm2 = 0, outside_mm2 = 0, curved_mm2 = 0, coaxial_mm2 = 0;
    for (const std::size_t i : others) {
        const StepFace& face = solid.faces[i];
        is_other[i] = true;
        if (const double offset = offsetOf_mm(face, axis); offset > 0) {
            eccentrics.push_back(i);
            offset_mm = std::max(offset_mm, offset);
        }
        if (face.kind == SurfaceKind::Plane && arePerpendicular(face.axis, axis.direction)) {
            planes.push_back(i);
            planes_mm2 += face.area_mm2;
        }
    }
    for (std::size_t i = 0; i < solid.faces.size(); ++i) {
        const StepFace& face = solid.faces[i];
        if (face.kind == SurfaceKind::Plane) continue;
        curved_mm2 += face.area_mm2;
        if (is_other[i]) continue;
        coaxial_mm2 += face.area_mm2;
        if (isTurnedOutside(face, axis)) outside_mm2 += face.area_mm2;
    }
    if (!eccentrics.empty()) refusePart(solid, eccentrics, axis, "eccentric", eccentric, offset_mm);
    const bool is_unturned = std::any_of(meridian.gaps.begin(), meridian.gaps.end(), [](const ContourPiece& gap) {
        return std::abs(gap.to_mm.x() - gap.from_mm.x()) > samePlace_mm;
    });
    if (planes_mm2 > outside_mm2 || (!planes.empty() && is_unturned))
        refusePart(solid, planes, axis, "prismatic", prismatic, unevenness_mm(solid, planes, axis));
    const bool is_turned = coaxial_mm2 >= curved_mm2 / 2;
    const auto which = others.empty() ? everyFace(solid) : others;
    refusePart(solid, which, axis, is_turned ? "not_round" : "no_single_axis", is_turned ? notRound : noSingleAxis,
               unevenness_mm(solid, which, axis));
}

}  // namespace lathelier::cad
