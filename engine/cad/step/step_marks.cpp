#include "engine/cad/step/step_marks.h"

#include <algorithm>
#include <cmath>

#include "engine/cad/step/milled_marks.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector3d;

constexpr double prismEnd_mm = 1e-3;  ///< as the z of its flats

FaceShape shapeOf(const StepFace& face, std::size_t number, const PartFrame& frame)
{
    FaceShape shape;
    shape.number = number;
    shape.kind = face.kind;
    shape.area_mm2 = face.area_mm2;
    shape.radius_mm = face.radius_mm;
    shape.point = frame.of(face.axis_point_mm);
    shape.axis = frame.directionOf(face.axis);
    const Vector3d outward = frame.directionOf(face.outward), inner = frame.of(face.inner_mm);
    if (face.kind == SurfaceKind::Plane) {
        if (outward.dot(shape.axis) < 0) shape.axis = -shape.axis;
    } else {
        const Vector3d from = inner - shape.point;
        shape.concave = outward.dot(from - from.dot(shape.axis) * shape.axis) < 0;
    }
    for (const Vector3d& vertex : face.vertices_mm) shape.boundary.push_back(frame.of(vertex));
    for (const auto& edge : face.edges_mm)
        for (const Vector3d& point : edge) shape.boundary.push_back(frame.of(point));
    shape.edge_numbers = face.edge_numbers;
    const Span z = spanOf(shape, Vector3d::UnitZ());
    shape.z = z;
    return shape;
}

/// Marks for the faces that nothing explains, merging those that overlap along z.
void addFreeForms(MarkedCuts& result, const std::vector<FaceShape>& shapes, const Shaft& turned)
{
    std::vector<const FaceShape*> faces;
    faces.reserve(shapes.size());
    for (const FaceShape& shape : shapes) faces.push_back(&shape);
    std::stable_sort(faces.begin(), faces.end(),
                     [](const FaceShape* a, const FaceShape* b) { return a->z.low < b->z.low; });
    const Contour contour = closedContour(turned);
    std::vector<ShaftMark> marks;
    for (const FaceShape* face : faces) {
        double depth_mm = 0;  // below the nearer of outside and bore
        for (const Vector3d& point : face->boundary) {
            const Ring ring = ringAt(contour, point.z());
            const double r = std::hypot(point.x(), point.y()), outside = ring.outer - r;
            depth_mm = std::max(depth_mm, ring.inner > 0 ? std::min(outside, r - ring.inner) : outside);
        }
        if (marks.empty() || face->z.low > *marks.back().z_end_mm) {
            marks.push_back({MarkKind::FreeForm, face->z.low, face->z.high});
            marks.back().deviation_mm = depth_mm;
            continue;
        }
        ShaftMark& mark = marks.back();
        mark.z_end_mm = std::max(*mark.z_end_mm, face->z.high);
        mark.deviation_mm = std::max(*mark.deviation_mm, depth_mm);
    }
    result.marks.insert(result.marks.end(), marks.begin(), marks.end());
}

}  // namespace

Vector3d PartFrame::of(const Vector3d& point) const
{
    return directionOf(point - origin_mm);
}

Vector3d PartFrame::directionOf(const Vector3d& direction) const
{
    return {direction.dot(x), direction.dot(y), direction.dot(z)};
}

PartFrame frameOf(const Line3& axis, double free_end_mm)
{
    constexpr double along = 0.9;  // cosine to the file's x axis above which its y axis is used
    PartFrame frame;
    frame.origin_mm = axis.point_mm + free_end_mm * axis.direction;
    frame.z = axis.direction;
    const Vector3d wanted = std::abs(axis.direction.x()) > along ? Vector3d::UnitY() : Vector3d::UnitX();
    frame.x = (wanted - wanted.dot(frame.z) * frame.z).normalized();
    frame.y = frame.z.cross(frame.x);
    return frame;
}

MarkedCuts marksOf(const std::vector<StepFace>& faces, const std::vector<std::size_t>& others, const PartFrame& frame,
                   const Shaft& turned, const Progress& progress)
{
    std::vector<FaceShape> shapes;
    for (const std::size_t i : others) {
        progress.check();
        shapes.push_back(shapeOf(faces[i], shapes.size(), frame));
    }
    NamedCuts holes = holesOf(shapes, turned);
    progress.check();
    NamedCuts milled = milledOf(shapes, std::move(holes.named), turned);
    MarkedCuts result;
    result.marks = std::move(holes.marks);
    result.marks.insert(result.marks.end(), milled.marks.begin(), milled.marks.end());
    result.cuts = std::move(holes.cuts);
    result.cuts.insert(result.cuts.end(), milled.cuts.begin(), milled.cuts.end());
    result.has_spline = std::any_of(result.marks.begin(), result.marks.end(),
                                    [](const ShaftMark& mark) { return mark.kind == MarkKind::Spline; });
    std::vector<FaceShape> unnamed;
    for (const FaceShape& shape : shapes)
        if (!milled.named[shape.number]) {
            unnamed.push_back(shape);
            result.unnamed.push_back(others[shape.number]);
        }
    addFreeForms(result, unnamed, turned);
    std::stable_sort(result.marks.begin(), result.marks.end(),
                     [](const ShaftMark& a, const ShaftMark& b) { return *a.z_start_mm < *b.z_start_mm; });
    return result;
}

MarkedCuts freeForms(const std::vector<StepFace>& faces, const std::vector<std::size_t>& others, const PartFrame& frame,
                     const Shaft& turned)
{
    MarkedCuts result;
    std::vector<FaceShape> shapes;
    shapes.reserve(others.size());
    for (const std::size_t i : others) shapes.push_back(shapeOf(faces[i], shapes.size(), frame));
    result.unnamed = others;
    addFreeForms(result, shapes, turned);
    return result;
}

bool isPrism(const std::vector<ShaftMark>& marks, double z_start_mm, double z_end_mm)
{
    return std::any_of(marks.begin(), marks.end(), [&](const ShaftMark& mark) {
        return (mark.kind == MarkKind::Hexagon || mark.kind == MarkKind::Square) &&
               *mark.z_start_mm<z_start_mm + prismEnd_mm&& * mark.z_end_mm> z_end_mm - prismEnd_mm;
    });
}

}  // namespace lathelier::cad
