// The only file that builds solids with OpenCASCADE.
#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <sstream>

#include "engine/cad/cad_codes.h"
#include "engine/cad/kernel_lock.h"
#include "engine/cad/step_kernel.h"

namespace lathelier::cad {
namespace {

[[noreturn]] void refuse(Text reason)
{
    throw Error(errors::solidNotBuilt, {{"reason", reason}});
}

/// (z, r) in the plane y = 0.
gp_Pnt pointOf(const Eigen::Vector2d& zr)
{
    return {zr.y(), 0, zr.x()};
}

TopoDS_Edge edgeOf(const ContourPiece& piece, const TopoDS_Vertex& from, const TopoDS_Vertex& to)
{
    if (!piece.isArc()) {
        BRepBuilderAPI_MakeEdge made(from, to);
        if (!made.IsDone()) refuse(LT_TEXT("Engine", "a piece of its contour makes no edge"));
        return made.Edge();
    }
    Eigen::Vector2d centre = piece.centre_mm();
    if (std::abs(centre.y()) < 1e-9) centre.y() = 0;  // a sphere
    // An explicit circle: one through three points deviates from the plane by rounding, and its face is then not a
    // torus. Angles grow from z to r about +y; a piece that bulges to the left turns the other way.
    const gp_Circ circle(gp_Ax2(pointOf(centre), gp_Dir(0, piece.arc_radius_mm > 0 ? -1 : 1, 0), gp_Dir(1, 0, 0)),
                         std::abs(piece.arc_radius_mm));
    BRepBuilderAPI_MakeEdge made(circle, from, to);
    if (!made.IsDone()) refuse(LT_TEXT("Engine", "an arc of its contour makes no edge"));
    return made.Edge();
}

TopoDS_Shape solidOf(const Contour& closed, const Progress& progress)
{
    std::vector<TopoDS_Vertex> corners;
    for (const ContourPiece& piece : closed)
        corners.push_back(BRepBuilderAPI_MakeVertex(pointOf(piece.from_mm)).Vertex());
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < closed.size(); ++i) {
        progress.check();
        wire.Add(edgeOf(closed[i], corners[i], corners[(i + 1) % corners.size()]));
    }
    if (closed.size() < 2 || !wire.IsDone()) refuse(LT_TEXT("Engine", "its contour is not closed"));
    BRepBuilderAPI_MakeFace face(wire.Wire(), true);
    if (!face.IsDone()) refuse(LT_TEXT("Engine", "its contour bounds no area"));
    BRepPrimAPI_MakeRevol revolved(face.Face(), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
    if (!revolved.IsDone()) refuse(LT_TEXT("Engine", "its contour cannot be revolved"));
    return revolved.Shape();
}

/// One valid solid of the volume expected.
TopoDS_Shape checkedSolid(const TopoDS_Shape& shape, const ExpectedVolume& expected)
{
    TopExp_Explorer solids(shape, TopAbs_SOLID);
    if (!solids.More()) refuse(LT_TEXT("Engine", "the revolved contour is no solid"));
    TopoDS_Shape solid = solids.Current();
    solids.Next();
    if (solids.More()) refuse(LT_TEXT("Engine", "the revolved contour is more than one solid"));
    if (!BRepCheck_Analyzer(solid).IsValid()) refuse(LT_TEXT("Engine", "the revolved contour is not valid"));
    GProp_GProps properties;  // the overload without a tolerance is exact for these surfaces
    BRepGProp::VolumeProperties(solid, properties);
    if (properties.Mass() < 0) solid.Reverse();
    const double found = std::abs(properties.Mass());
    if (!(std::abs(found - expected.volume_mm3) <= expected.tolerance_mm3))
        throw Error(errors::solidVolumeWrong, {{"found_mm3", found}, {"expected_mm3", expected.volume_mm3}});
    return solid;
}

Handle(TCollection_HAsciiString) text(const char* ascii)
{
    return new TCollection_HAsciiString(ascii);
}

void setTexts(const Handle(StepData_StepModel) & model)
{
    APIHeaderSection_MakeHeader header(model);
    header.SetName(text(placeholders::file));
    header.SetTimeStamp(text(placeholders::time));
    header.SetAuthorValue(1, text(placeholders::author));
    header.SetOrganizationValue(1, text(placeholders::organisation));
    header.SetPreprocessorVersion(text(placeholders::kernel));
    header.SetOriginatingSystem(text(placeholders::system));
    header.SetAuthorisation(text(""));
    header.SetDescriptionValue(1, text("turned part"));
    // The kernel counts products over the life of the process: "shaft 2".
    for (Standard_Integer i = 1; i <= model->NbEntities(); ++i) {
        const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Value(i));
        if (product.IsNull()) continue;
        product->SetId(text(placeholders::product));
        product->SetName(text(placeholders::product));
        product->SetDescription(text(placeholders::description));
    }
}

std::string written(const TopoDS_Shape& solid, StepSchema schema)
{
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.schema", schema == StepSchema::AP242 ? "AP242DIS" : "AP214IS");
    Interface_Static::SetCVal("write.step.unit", "MM");
    const Handle(StepData_StepModel) model = writer.Model(true);
    if (writer.Transfer(solid, STEPControl_AsIs) != IFSelect_RetDone)
        refuse(LT_TEXT("Engine", "the solid cannot be written as STEP"));
    setTexts(model);
    // As STEPControl_Writer::Write(), but to memory.
    StepData_StepWriter text_writer(model);
    text_writer.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    if (!text_writer.Print(stream)) refuse(LT_TEXT("Engine", "the solid cannot be written as STEP"));
    return std::move(stream).str();
}

}  // namespace

std::string revolvedStepByKernel(const Contour& closed, StepSchema schema, const ExpectedVolume& expected,
                                 const Progress& progress)
{
    const std::scoped_lock lock(kernelMutex());
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        const TopoDS_Shape solid = checkedSolid(solidOf(closed, progress), expected);
        progress.report(0.5);
        std::string step = written(solid, schema);
        progress.report(1);
        return step;
    } catch (const Standard_Failure&) {
        refuse(LT_TEXT("Engine", "the revolved contour is not valid"));
    }
}

}  // namespace lathelier::cad
