#include "widgets/part_common/part_exports.h"

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

namespace lathelier::part_common {
namespace {

constexpr int resolution_dpi = 1200;

struct PartFiles {
    Q_DECLARE_TR_FUNCTIONS(lathelier::part_common::PartFiles)
};

std::string step(const PartToWrite& part, cad::StepSchema schema)
{
    cad::StepOptions options;
    options.schema = schema;
    return cad::stepText(part.shaft, options);
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

std::vector<PanelExport> exportsOf(const std::shared_ptr<const PartToWrite>& part)
{
    using P = PartToWrite;
    std::vector<PanelExport> all;
    const auto add = [&](const QString& label, const QString& filter, const QString& suffix, bool complete,
                         const std::function<std::string(const P&)>& content) {
        all.push_back({label, filter, suffix, [part, complete, content](const QString& path) {
                           if (complete && part->require_complete) part->require_complete();
                           io::writeFile(path.toStdString(), content(*part));
                       }});
    };
    constexpr bool whole = true, any = false;
    add(PartFiles::tr("Drawing (PDF)…"), PartFiles::tr("Document (*.pdf)"), "pdf", whole,
        [](const P& p) { return toPdf(p.drawing(screenLanguage())); });
    add(PartFiles::tr("Drawing (SVG)…"), PartFiles::tr("Picture (*.svg)"), "svg", whole,
        [](const P& p) { return drawing::toSvg(p.drawing(screenLanguage())); });
    add(PartFiles::tr("Drawing (DXF)…"), PartFiles::tr("Drawing (*.dxf)"), "dxf", whole,
        [](const P& p) { return cad::dxfText(cad::dxfOf(p.drawing(screenLanguage()))); });
    add(PartFiles::tr("Contour (DXF)…"), PartFiles::tr("Drawing (*.dxf)"), "dxf", whole,
        [](const P& p) { return cad::contourDxf(p.shaft); });
    add(PartFiles::tr("Solid (STEP AP214)…"), PartFiles::tr("Solid (*.step)"), "step", whole,
        [](const P& p) { return step(p, cad::StepSchema::AP214); });
    add(PartFiles::tr("Solid (STEP AP242)…"), PartFiles::tr("Solid (*.step)"), "step", whole,
        [](const P& p) { return step(p, cad::StepSchema::AP242); });
    add(PartFiles::tr("FreeCAD macro…"), PartFiles::tr("FreeCAD macro (*.FCMacro)"), "FCMacro", whole,
        [](const P& p) { return cad::freecadMacro(p.shaft); });
    add(PartFiles::tr("SolidWorks macro…"), PartFiles::tr("SolidWorks macro (*.bas)"), "bas", whole,
        [](const P& p) { return cad::solidworksMacro(p.shaft); });
    add(PartFiles::tr("Table of rows (CSV)…"), PartFiles::tr("Table (*.csv)"), "csv", any,
        [](const P& p) { return p.csv ? p.csv() : cad::shaftCsv(p.shaft); });
    add(PartFiles::tr("Shaft (SHAFT.json)…"), PartFiles::tr("JSON (*.json)"), "json", any,
        [](const P& p) { return io::shaftText(p.shaft); });
    add(PartFiles::tr("Stock text…"), PartFiles::tr("Text (*.txt)"), "txt", whole,
        [](const P& p) { return io::stockText(p.stock); });
    return all;
}

}  // namespace lathelier::part_common
