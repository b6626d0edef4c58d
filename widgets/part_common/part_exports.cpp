#include "widgets/drawing/drawing_files.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <functional>

#include "engine/cad/drawing_dxf.h"
#include "engine/cad/dxf_writer.h"
#include "engine/cad/freecad_macro.h"
#include "engine/cad/shaft_csv.h"
#include "engine/cad/solidworks_macro.h"
#include "engine/cad/step_writer.h"
#include "engine/drawing/drawing_svg.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "widgets/core/language.h"

namespace lathelier::drawing_panel {
namespace {

constexpr int resolution_dpi = 1200;

struct DrawingFiles {
    Q_DECLARE_TR_FUNCTIONS(lathelier::drawing_panel::DrawingFiles)
};

std::string step(const DrawingPicture& picture, cad::StepSchema schema)
{
    cad::StepOptions options;
    options.schema = schema;
    return cad::stepText(picture.shaft, options);
}

}  // namespace

std::string toPdf(const drawing::Drawing& drawing)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    const drawing::Box sheet = drawing::sheetBox(drawing.sheet);
    const bool lies = sheet.width_mm() > sheet.height_mm();
    writer.setTitle(QString::fromStdString(drawing.title));
    writer.setCreator("Lathelier");
    writer.setResolution(resolution_dpi);
    writer.setPageLayout(
        QPageLayout(QPageSize(drawing.sheet == drawing::Sheet::A3Landscape ? QPageSize::A3 : QPageSize::A4),
                    lies ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF()));
    QPainter painter(&writer);
    QSvgRenderer svg(QByteArray::fromStdString(drawing::toSvg(drawing)));
    svg.render(&painter, QRectF(0, 0, writer.width(), writer.height()));
    painter.end();
    return buffer.data().toStdString();
}

std::vector<PanelExport> exportsOf(const std::shared_ptr<const DrawingPicture>& picture)
{
    std::vector<PanelExport> all;
    const auto add = [&](const QString& label, const QString& filter, const QString& suffix,
                         const std::function<std::string(const DrawingPicture&)>& content) {
        all.push_back({label, filter, suffix, [picture, content](const QString& path) {
                           io::writeFile(path.toStdString(), content(*picture));
                       }});
    };
    using P = DrawingPicture;
    add(DrawingFiles::tr("Drawing (PDF)…"), DrawingFiles::tr("Document (*.pdf)"), "pdf",
        [](const P& p) { return toPdf(drawingOf(p, screenLanguage())); });
    add(DrawingFiles::tr("Drawing (SVG)…"), DrawingFiles::tr("Picture (*.svg)"), "svg",
        [](const P& p) { return drawing::toSvg(drawingOf(p, screenLanguage())); });
    add(DrawingFiles::tr("Drawing (DXF)…"), DrawingFiles::tr("Drawing (*.dxf)"), "dxf",
        [](const P& p) { return cad::dxfText(cad::dxfOf(drawingOf(p, screenLanguage()))); });
    add(DrawingFiles::tr("Contour (DXF)…"), DrawingFiles::tr("Drawing (*.dxf)"), "dxf",
        [](const P& p) { return cad::contourDxf(p.shaft); });
    add(DrawingFiles::tr("Solid (STEP AP214)…"), DrawingFiles::tr("Solid (*.step)"), "step",
        [](const P& p) { return step(p, cad::StepSchema::AP214); });
    add(DrawingFiles::tr("Solid (STEP AP242)…"), DrawingFiles::tr("Solid (*.step)"), "step",
        [](const P& p) { return step(p, cad::StepSchema::AP242); });
    add(DrawingFiles::tr("FreeCAD macro…"), DrawingFiles::tr("FreeCAD macro (*.FCMacro)"), "FCMacro",
        [](const P& p) { return cad::freecadMacro(p.shaft); });
    add(DrawingFiles::tr("SolidWorks macro…"), DrawingFiles::tr("SolidWorks macro (*.bas)"), "bas",
        [](const P& p) { return cad::solidworksMacro(p.shaft); });
    add(DrawingFiles::tr("Table of rows (CSV)…"), DrawingFiles::tr("Table (*.csv)"), "csv",
        [](const P& p) { return cad::shaftCsv(p.shaft); });
    add(DrawingFiles::tr("Shaft (SHAFT.json)…"), DrawingFiles::tr("JSON (*.json)"), "json",
        [](const P& p) { return io::shaftText(p.shaft); });
    add(DrawingFiles::tr("Stock text…"), DrawingFiles::tr("Text (*.txt)"), "txt",
        [](const P& p) { return io::stockText(p.shaft); });
    return all;
}

}  // namespace lathelier::drawing_panel
