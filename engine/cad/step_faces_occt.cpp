// The only file that reads STEP with OpenCASCADE.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Curve.hxx>
#include <Interface_Check.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Precision.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Conic.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_Line.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepGeom_Vector.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_VertexPoint.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <new>
#include <numbers>
#include <sstream>

#include "engine/cad/cad_codes.h"
#include "engine/cad/kernel_lock.h"
#include "engine/cad/step_kernel.h"
#include "engine/io/io_codes.h"

namespace lathelier::cad {
namespace {

constexpr int pointsOfEdge = 24;
constexpr double splineTolerance = 1e-10;  ///< relative, of integrals over splines; volumes are then right to 1e-5

Eigen::Vector3d vector(const gp_XYZ& v)
{
    return {v.X(), v.Y(), v.Z()};
}

/// Passes cancellation to the kernel.
class Stop : public Message_ProgressIndicator {
public:
    explicit Stop(const Progress& progress) : progress_(progress) {}

protected:
    Standard_Boolean UserBreak() override { return progress_.stopped(); }
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

private:
    Progress progress_;
};

[[noreturn]] void refuseRecord(std::int64_t line)
{
    throw Error(errors::malformed, {{"line", line},
                                    {"column", std::int64_t{1}},
                                    {"found", LT_TEXT("Engine", "a record that does not fit")},
                                    {"expected", LT_TEXT("Engine", "a record as its schema describes it")}});
}

bool isPointInSpace(const Handle(StepGeom_Point) & stated)
{
    const Handle(StepGeom_CartesianPoint) point = Handle(StepGeom_CartesianPoint)::DownCast(stated);
    return !point.IsNull() && point->NbCoordinates() == 3;
}

bool isDirectionInSpace(const Handle(StepGeom_Direction) & direction)
{
    return !direction.IsNull() && !direction->DirectionRatios().IsNull() && direction->NbDirectionRatios() == 3;
}

/// True if the record has the three coordinates that the kernel assumes.
bool isInSpace(const Handle(Standard_Transient) & record)
{
    if (const auto vertex = Handle(StepShape_VertexPoint)::DownCast(record); !vertex.IsNull())
        return isPointInSpace(vertex->VertexGeometry());
    if (const auto frame = Handle(StepGeom_Axis2Placement3d)::DownCast(record); !frame.IsNull())
        return isPointInSpace(frame->Location()) && (!frame->HasAxis() || isDirectionInSpace(frame->Axis())) &&
               (!frame->HasRefDirection() || isDirectionInSpace(frame->RefDirection()));
    if (const auto edge = Handle(StepShape_EdgeCurve)::DownCast(record); !edge.IsNull()) {
        const auto line = Handle(StepGeom_Line)::DownCast(edge->EdgeGeometry());
        const auto conic = Handle(StepGeom_Conic)::DownCast(edge->EdgeGeometry());
        return (line.IsNull() || (isPointInSpace(line->Pnt()) && !line->Dir().IsNull() &&
                                  isDirectionInSpace(line->Dir()->Orientation()))) &&
               (conic.IsNull() || !conic->Position().Axis2Placement3d().IsNull()) &&
               Handle(StepGeom_Pcurve)::DownCast(edge->EdgeGeometry()).IsNull();
    }
    return true;
}

/// The kernel continues with records whose parameters it could not read. Such records are incomplete, so all are
/// checked before any is used.
void refuseBrokenRecords(const Handle(StepData_StepModel) & model, const Part21& checked)
{
    const auto refuse = [&](Standard_Integer i) {
        const auto line = checked.line_of_record.find(model->IdentLabel(model->Value(i)));
        refuseRecord(line == checked.line_of_record.end() ? 1 : line->second);
    };
    for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
        const Handle(Interface_Check) check = model->Check(i, true);
        if (!check.IsNull() && check->HasFailed()) refuse(i);
    }
    for (Standard_Integer i = 1; i <= model->NbEntities(); ++i)
        if (!isInSpace(model->Value(i))) refuse(i);
}

/// Removes curves in surface parameters: they are redundant, and the kernel does not check their types.
void forgetParameterCurves(const Handle(StepData_StepModel) & model)
{
    for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
        const Handle(StepShape_EdgeCurve) edge = Handle(StepShape_EdgeCurve)::DownCast(model->Value(i));
        if (edge.IsNull() || edge->EdgeGeometry().IsNull()) continue;
        const Handle(StepGeom_SurfaceCurve) curve = Handle(StepGeom_SurfaceCurve)::DownCast(edge->EdgeGeometry());
        if (!curve.IsNull()) edge->SetEdgeGeometry(curve->Curve3d());
    }
}

void takeAxis(StepFace& face, const gp_Ax1& axis)
{
    face.axis_point_mm = vector(axis.Location().XYZ());
    face.axis = vector(axis.Direction().XYZ());
}

/// Centre of the meridian circle in the half plane of `point`: `centre` turned about the axis.
Eigen::Vector3d turnedTo(const StepFace& face, const Eigen::Vector3d& centre, const Eigen::Vector3d& of,
                         const Eigen::Vector3d& point)
{
    const auto radial = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        const Eigen::Vector3d d = p - face.axis_point_mm;
        return d - d.dot(face.axis) * face.axis;
    };
    const double along = (centre - face.axis_point_mm).dot(face.axis);
    const Eigen::Vector3d from = radial(of).normalized(), to = radial(point).normalized();
    return face.axis_point_mm + along * face.axis + radial(centre).dot(from) * to;
}

void describeSurface(StepFace& face, const BRepAdaptor_Surface& surface, double v)
{
    switch (surface.GetType()) {
        case GeomAbs_Plane:
            face.kind = SurfaceKind::Plane;
            takeAxis(face, surface.Plane().Axis());
            return;
        case GeomAbs_Cylinder:
            face.kind = SurfaceKind::Cylinder;
            takeAxis(face, surface.Cylinder().Axis());
            face.radius_mm = surface.Cylinder().Radius();
            return;
        case GeomAbs_Cone:
            face.kind = SurfaceKind::Cone;
            takeAxis(face, surface.Cone().Axis());
            return;
        case GeomAbs_Sphere:
            face.kind = SurfaceKind::Sphere;
            takeAxis(face, gp_Ax1(surface.Sphere().Location(), surface.Sphere().Position().Direction()));
            face.radius_mm = surface.Sphere().Radius();
            face.circle_centre_mm = face.axis_point_mm;
            return;
        case GeomAbs_Torus: {
            face.kind = SurfaceKind::Torus;
            takeAxis(face, surface.Torus().Axis());
            face.radius_mm = surface.Torus().MinorRadius();
            const Eigen::Vector3d d = face.inner_mm - face.axis_point_mm;
            const Eigen::Vector3d radial = d - d.dot(face.axis) * face.axis;
            // For the inner part of a spindle torus the point lies on the other side of the axis from the circle
            // centre.
            const double tube = (surface.Torus().MajorRadius() + face.radius_mm * std::cos(v)) < 0 ? -1 : 1;
            face.circle_centre_mm = face.axis_point_mm + tube * surface.Torus().MajorRadius() * radial.normalized();
            return;
        }
        case GeomAbs_SurfaceOfRevolution: {
            takeAxis(face, surface.AxeOfRevolution());
            const Handle(Adaptor3d_Curve) basis = surface.BasisCurve();
            if (basis->GetType() == GeomAbs_Line) {
                face.kind = SurfaceKind::RevolvedLine;
            } else if (basis->GetType() == GeomAbs_Circle) {
                face.kind = SurfaceKind::RevolvedArc;
                face.radius_mm = basis->Circle().Radius();
                face.circle_centre_mm = turnedTo(face, vector(basis->Circle().Location().XYZ()),
                                                 vector(basis->Value(v).XYZ()), face.inner_mm);
            }
            return;
        }
        default: return;
    }
}

/// Integrals over rational splines of few spans are wrong by percents without a tolerance.
bool isSpline(const BRepAdaptor_Surface& surface)
{
    return surface.GetType() == GeomAbs_BSplineSurface || surface.GetType() == GeomAbs_BezierSurface;
}

/// Points and normals within the bounds of the parameters.
std::vector<SurfaceSpot> spotsOf(const BRepAdaptor_Surface& surface, double u0, double u1, double v0, double v1)
{
    constexpr int steps = 9;
    std::vector<SurfaceSpot> spots;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            gp_Pnt point;
            gp_Vec along_u, along_v;
            surface.D1(u0 + (u1 - u0) * (i + 0.5) / steps, v0 + (v1 - v0) * (j + 0.5) / steps, point, along_u, along_v);
            const Eigen::Vector3d normal = vector(along_u.Crossed(along_v).XYZ());
            if (normal.norm() > 0) spots.push_back({vector(point.XYZ()), normal.normalized()});
        }
    return spots;
}

StepFace describe(const TopoDS_Face& topology, const TopTools_IndexedMapOfShape& edges, const Progress& progress)
{
    StepFace face;
    const BRepAdaptor_Surface surface(topology);
    GProp_GProps area;
    if (isSpline(surface))
        BRepGProp::SurfaceProperties(topology, area, splineTolerance);
    else
        BRepGProp::SurfaceProperties(topology, area);
    progress.check();
    face.area_mm2 = std::abs(area.Mass());
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepTools::UVBounds(topology, u0, u1, v0, v1);
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface.D1((u0 + u1) / 2, (v0 + v1) / 2, point, along_u, along_v);
    face.inner_mm = vector(point.XYZ());
    const Eigen::Vector3d normal = vector(along_u.Crossed(along_v).XYZ());
    if (normal.norm() > 0) face.outward = normal.normalized();
    if (topology.Orientation() == TopAbs_REVERSED) face.outward = -face.outward;
    describeSurface(face, surface, (v0 + v1) / 2);
    if (face.kind == SurfaceKind::Other) face.spots = spotsOf(surface, u0, u1, v0, v1);
    for (TopExp_Explorer at(topology, TopAbs_VERTEX); at.More(); at.Next())
        face.vertices_mm.push_back(vector(BRep_Tool::Pnt(TopoDS::Vertex(at.Current())).XYZ()));
    for (TopExp_Explorer at(topology, TopAbs_EDGE); at.More(); at.Next()) {
        progress.check();
        const TopoDS_Edge edge = TopoDS::Edge(at.Current());
        face.edge_numbers.push_back(edges.FindIndex(edge));
        double t0 = 0, t1 = 0;
        if (BRep_Tool::Degenerated(edge) || BRep_Tool::Curve(edge, t0, t1).IsNull()) continue;
        if (Precision::IsInfinite(t0) || Precision::IsInfinite(t1)) continue;
        const BRepAdaptor_Curve curve(edge);
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i <= pointsOfEdge; ++i)
            points.push_back(vector(curve.Value(t0 + (t1 - t0) * i / pointsOfEdge).XYZ()));
        face.edges_mm.push_back(std::move(points));
    }
    return face;
}

bool isFinite(const StepFace& face)
{
    bool finite = std::isfinite(face.area_mm2) && face.axis_point_mm.allFinite() && face.circle_centre_mm.allFinite() &&
                  face.inner_mm.allFinite() && face.outward.allFinite();
    for (const SurfaceSpot& spot : face.spots) finite = finite && spot.point_mm.allFinite() && spot.normal.allFinite();
    for (const Eigen::Vector3d& vertex : face.vertices_mm) finite = finite && vertex.allFinite();
    for (const auto& edge : face.edges_mm)
        for (const Eigen::Vector3d& point : edge) finite = finite && point.allFinite();
    return finite;
}

StepSolid readSolid(std::string_view bytes, const Part21& checked, const Progress& progress)
{
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    std::istringstream stream{std::string(bytes)};
    if (reader.ReadStream("part.step", stream) != IFSelect_RetDone) refuseRecord(1);
    progress.report(0.3);
    const Handle(StepData_StepModel) model = reader.StepModel();
    if (model.IsNull()) refuseRecord(1);
    forgetParameterCurves(model);
    refuseBrokenRecords(model, checked);
    const Handle(Message_ProgressIndicator) indicator = new Stop(progress);
    reader.TransferRoots(indicator->Start());
    progress.report(0.7);
    std::vector<TopoDS_Shape> solids;
    for (Standard_Integer i = 1; i <= reader.NbShapes(); ++i)
        for (TopExp_Explorer at(reader.Shape(i), TopAbs_SOLID); at.More(); at.Next()) solids.push_back(at.Current());
    if (solids.empty()) throw Error(errors::noSolid, {});
    if (solids.size() > 1) throw Error(errors::severalParts, {{"count", static_cast<std::int64_t>(solids.size())}});

    StepSolid result;
    for (Standard_Integer i = 1; i <= model->NbEntities() && result.product.empty(); ++i) {
        const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Value(i));
        if (!product.IsNull() && !product->Name().IsNull()) result.product = product->Name()->ToCString();
    }
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solids.front(), TopAbs_EDGE, edges);
    for (TopExp_Explorer at(solids.front(), TopAbs_FACE); at.More(); at.Next()) {
        StepFace face = describe(TopoDS::Face(at.Current()), edges, progress);
        if (!isFinite(face)) refuseRecord(1);
        result.faces.push_back(std::move(face));
    }
    bool has_spline = false;
    for (TopExp_Explorer at(solids.front(), TopAbs_FACE); at.More() && !has_spline; at.Next())
        has_spline = isSpline(BRepAdaptor_Surface(TopoDS::Face(at.Current())));
    progress.check();
    GProp_GProps volume;  // the overload without a tolerance is exact for all surfaces but splines
    if (has_spline)
        BRepGProp::VolumeProperties(solids.front(), volume, splineTolerance);
    else
        BRepGProp::VolumeProperties(solids.front(), volume);
    result.volume_mm3 = volume.Mass();
    if (!std::isfinite(result.volume_mm3)) refuseRecord(1);
    if (result.volume_mm3 < 0) {  // reversed orientation
        result.volume_mm3 = -result.volume_mm3;
        for (StepFace& face : result.faces) face.outward = -face.outward;
    }
    progress.report(1);
    return result;
}

}  // namespace

StepSolid readStepFacesByKernel(std::string_view bytes, const Part21& checked, const Progress& progress)
{
    const std::scoped_lock lock(kernelMutex());
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        return readSolid(bytes, checked, progress);
    } catch (const Standard_Failure&) {
        progress.check();
        refuseRecord(1);
    } catch (const std::bad_alloc&) {
        refuseRecord(1);
    }
}

}  // namespace lathelier::cad
