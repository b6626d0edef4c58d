#include "engine/cad/task/part_files.h"

#include <fmt/format.h>

#include <ctime>

#include "engine/cad/drawing_dxf.h"
#include "engine/cad/dxf_writer.h"
#include "engine/cad/freecad_macro.h"
#include "engine/cad/shaft_csv.h"
#include "engine/cad/solidworks_macro.h"
#include "engine/cad/step_writer.h"
#include "engine/drawing/drawing_svg.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier::cad {
namespace {

constexpr const char* stockExport = "stock";
constexpr const char* dxfExport = "dxf";
constexpr const char* tableExport = "csv";

std::string stepOf(const PartToWrite& part, const Progress& progress)
{
    StepOptions options;
    if (part.cad.step_schema == "AP242") options.schema = StepSchema::AP242;
    if (part.cad.undated) options.time_stamp = std::string();
    return stepText(part.shaft, options, progress);
}

std::string dxfOfPart(const PartToWrite& part, const Language& language)
{
    requireSolidOfRows(part.shaft);
    return part.cad.dxf_contour ? contourDxf(part.shaft) : dxfText(dxfOf(part.drawing(language)));
}

}  // namespace

const std::vector<Field<CadQuestion>>& fieldsOf(const CadQuestion*)
{
    using Q = CadQuestion;
    static const auto all = [] {
        auto list = described<Q>(
            choice("step_schema", &Q::step_schema,
                   {{"AP214", LT_TEXT("Engine", "AP214")}, {"AP242", LT_TEXT("Engine", "AP242")}},
                   Label{LT_TEXT("Engine", "Schema of STEP"),
                         LT_TEXT("Engine", "Application protocol that the STEP file names.")}),
            field("dxf_contour", &Q::dxf_contour,
                  Label{LT_TEXT("Engine", "Contour as DXF"),
                        LT_TEXT("Engine", "The closed half contour for CAM in place of the drawing.")}),
            field("undated", &Q::undated,
                  Label{LT_TEXT("Engine", "Without a date"),
                        LT_TEXT("Engine", "No date in drawing, DXF and STEP: the same shaft gives the same bytes.")}));
        for (Field<Q>& one : list) one.info.advanced = true;
        return list;
    }();
    return all;
}

const std::vector<Field<TitleQuestion>>& fieldsOf(const TitleQuestion*)
{
    using Q = TitleQuestion;
    static const auto all = [] {
        auto list = described<Q>(
            choice("library_material", &Q::material,
                   receptance::materialChoices(LT_TEXT("Engine", "as the file states")),
                   Label{LT_TEXT("Engine", "Material"),
                         LT_TEXT("Engine", "Handbook values of the library are marked as assumed.")}),
            field("material_name", &Q::material_name,
                  Label{LT_TEXT("Engine", "Material name"),
                        LT_TEXT("Engine", "As printed in the title block; empty: the name of the material.")}),
            field("general_tolerances", &Q::general_tolerances,
                  Label{LT_TEXT("Engine", "General tolerances"),
                        LT_TEXT("Engine", "Such as ISO 2768-m; empty: as the input has them, else none.")}),
            field("surface_texture", &Q::surface_texture,
                  Label{LT_TEXT("Engine", "Surface texture"),
                        LT_TEXT("Engine", "Note in the title block, such as Rz 16; empty: none.")}),
            field("author", &Q::author, Label{LT_TEXT("Engine", "Author"), LT_TEXT("Engine", "Empty: none.")}),
            field("date", &Q::date, Label{LT_TEXT("Engine", "Date"), LT_TEXT("Engine", "As printed; empty: today.")}));
        for (Field<Q>& one : list) one.info.group = LT_TEXT("Engine", "Title block");
        return list;
    }();
    return all;
}

void addTitle(const TitleQuestion& title, Shaft& shaft, Notes& notes)
{
    receptance::chooseMaterial(title.material, shaft, notes);
    if (!title.general_tolerances.empty()) shaft.general_tolerance = title.general_tolerances;
}

drawing::DrawingOptions drawingOptions(const TitleQuestion& title, const CadQuestion& cad, const Language& language)
{
    drawing::DrawingOptions options;
    options.material = title.material_name;
    options.surface_texture = title.surface_texture;
    options.author = title.author;
    if (!cad.undated) options.date = title.date.empty() ? today() : title.date;
    options.decimal_separator = decimalMark(language);
    options.translate = [&language](Text english) { return text(english, language); };
    return options;
}

std::vector<task::Export> partExports()
{
    const Text drawing = LT_TEXT("Engine", "Drawing (*.dxf)");
    return {{shaftExport, "Write the shaft as FILE.json.", LT_TEXT("Engine", "Shaft (SHAFT.json)…"),
             LT_TEXT("Engine", "JSON (*.json)"), "json"},
            {stockExport, "Write the contour as a stock file FILE.txt.", LT_TEXT("Engine", "Stock text…"),
             LT_TEXT("Engine", "Text (*.txt)"), "txt"},
            {stepExport, "Write a solid as FILE.step.", LT_TEXT("Engine", "Solid (STEP)…"),
             LT_TEXT("Engine", "Solid (*.step)"), "step", true},
            {dxfExport, "Write FILE.dxf (R12).", LT_TEXT("Engine", "Drawing or contour (DXF)…"), drawing, "dxf", true},
            {freecadExport, "Write a macro for FreeCAD, FILE.FCMacro.", LT_TEXT("Engine", "FreeCAD macro…"),
             LT_TEXT("Engine", "FreeCAD macro (*.FCMacro)"), "FCMacro", true},
            {solidworksExport, "Write a macro for SolidWorks, FILE.bas.", LT_TEXT("Engine", "SolidWorks macro…"),
             LT_TEXT("Engine", "SolidWorks macro (*.bas)"), "bas", true},
            {tableExport, "Write all rows as FILE.csv.", LT_TEXT("Engine", "Table of rows (CSV)…"),
             LT_TEXT("Engine", "Table (*.csv)"), "csv"},
            {drawingExport, "Write the workshop drawing as FILE.svg.", LT_TEXT("Engine", "Drawing (SVG)…"),
             LT_TEXT("Engine", "Picture (*.svg)"), "svg", true}};
}

std::map<std::string, task::WriteExport> partWriters(const std::shared_ptr<const PartToWrite>& part)
{
    using Content = std::function<std::string(const Language&, const Progress&)>;
    const auto whole = [part](const Content& content) -> task::WriteExport {
        return [part, content](const std::string& path, const Language& language, const Progress& progress) {
            if (part->require_complete) part->require_complete();
            io::writeFile(path, content(language, progress));
        };
    };
    std::map<std::string, task::WriteExport> all;
    all[shaftExport] = [part](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, io::shaftText(part->shaft));
    };
    all[stockExport] = whole([part](const Language&, const Progress&) { return io::stockText(part->stock); });
    all[stepExport] = whole([part](const Language&, const Progress& progress) { return stepOf(*part, progress); });
    all[dxfExport] = whole([part](const Language& language, const Progress&) { return dxfOfPart(*part, language); });
    all[freecadExport] = whole([part](const Language&, const Progress&) { return freecadMacro(part->shaft); });
    all[solidworksExport] = whole([part](const Language&, const Progress&) { return solidworksMacro(part->shaft); });
    all[tableExport] =
        whole([part](const Language&, const Progress&) { return part->csv ? part->csv() : shaftCsv(part->shaft); });
    all[drawingExport] =
        whole([part](const Language& language, const Progress&) { return drawing::toSvg(part->drawing(language)); });
    return all;
}

bool isSolidWanted(const task::Wanted& wanted)
{
    return wanted.has(stepExport) || wanted.has(freecadExport) || wanted.has(solidworksExport);
}

std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return fmt::format("{:04}-{:02}-{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
}

std::string decimalMark(const Language& language)
{
    const std::string half = fixed(0.5, 1, language);
    return half.size() > 2 ? half.substr(1, half.size() - 2) : ".";
}

}  // namespace lathelier::cad
