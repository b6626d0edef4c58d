#include "app/cli/shaft_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>

#include "engine/cad/cad_codes.h"
#include "engine/cad/cad_notes.h"
#include "engine/cad/drawing_dxf.h"
#include "engine/cad/dxf_writer.h"
#include "engine/cad/freecad_macro.h"
#include "engine/cad/shaft_csv.h"
#include "engine/cad/solidworks_macro.h"
#include "engine/cad/step_writer.h"
#include "engine/cad/steps_view.h"
#include "engine/core/understanding.h"
#include "engine/core/visible.h"
#include "engine/drawing/drawing_svg.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/features/features_codes.h"
#include "engine/features/stock_part.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cli {
namespace {

constexpr const char* shaftOption = "--shaft";
constexpr const char* stockOption = "--stock";
constexpr const char* stepOption = "--step";
constexpr const char* dxfOption = "--dxf";
constexpr const char* freecadOption = "--freecad";
constexpr const char* solidworksOption = "--solidworks";
constexpr const char* drawingOption = "--drawing";
constexpr const char* schemaKey = "step_schema";
constexpr const char* contourKey = "dxf_contour";
constexpr const char* undatedKey = "undated";

/// The date of today as ISO 8601 has it.
std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return fmt::format("{:04}-{:02}-{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
}

bool isAsked(const Request& request, const char* key)
{
    const Value* const value = find(request.parameters, key);
    return value && *value == Value(true);
}

drawing::Drawing drawingOf(const ShaftToWrite& asked, bool undated)
{
    drawing::DrawingOptions options;
    options.scan = asked.scan;
    options.measured = asked.measured;
    options.uncertainties = asked.uncertainties;
    options.bore_uncertainties = asked.bore_uncertainties;
    if (!undated) options.date = today();
    return drawing::drawShaft(asked.shaft, options);
}

/// What a part is made by: not written where something of it was not understood. Error not_modelled.
void requireUnderstoodFor(const Request& request, const Notes& notes)
{
    for (const char* option : {stepOption, dxfOption, freecadOption, solidworksOption, drawingOption})
        if (request.outputs.count(option) > 0) return requireUnderstood(understandingOf(notes));
}

}  // namespace

std::vector<OutputOption> shaftOutputs()
{
    return {{shaftOption, "Write the shaft as FILE.json."},
            {stockOption, "Write the contour as a stock file FILE.txt."},
            {stepOption, "Write a solid as FILE.step."},
            {dxfOption, "Write FILE.dxf (R12)."},
            {freecadOption, "Write a macro for FreeCAD, FILE.FCMacro."},
            {solidworksOption, "Write a macro for SolidWorks, FILE.bas."},
            {tableOption, "Write all rows as FILE.csv."},
            {drawingOption, "Write the workshop drawing as FILE.svg."}};
}

std::vector<Option> cadOptions()
{
    FieldInfo schema;
    schema.key = schemaKey;
    schema.kind = FieldInfo::Kind::Choice;
    schema.label = LT_TEXT("Engine", "Schema of STEP");
    schema.help = LT_TEXT("Engine", "Application protocol that the STEP file names.");
    schema.choices = {{"AP214", LT_TEXT("Engine", "AP214")}, {"AP242", LT_TEXT("Engine", "AP242")}};
    FieldInfo contour;
    contour.key = contourKey;
    contour.kind = FieldInfo::Kind::Flag;
    contour.label = LT_TEXT("Engine", "Contour as DXF");
    contour.help = LT_TEXT("Engine", "The closed half contour for CAM in place of the drawing.");
    FieldInfo undated;
    undated.key = undatedKey;
    undated.kind = FieldInfo::Kind::Flag;
    undated.label = LT_TEXT("Engine", "Without a date");
    undated.help = LT_TEXT("Engine", "No date in drawing, DXF and STEP: the same shaft gives the same bytes.");
    return {{schema, std::string("AP214")}, {contour, false}, {undated, false}};
}

Json stepsJson(const Shaft& shaft)
{
    Json steps = Json::array();
    for (const ShaftStep& step : cad::stepsOf(shaft))
        steps.push_back({{"x_mm", step.x_mm},
                         {"y_mm", step.y_mm},
                         {"radius_mm", step.radius_mm},
                         {"z_start_mm", step.z_start_mm},
                         {"z_end_mm", step.z_end_mm},
                         {"chamfer_start_mm", step.chamfer_start_mm},
                         {"chamfer_end_mm", step.chamfer_end_mm}});
    return steps;
}

std::string shaftSummary(const Shaft& shaft)
{
    std::string text = fmt::format("{:>4} {:>10} {:>10} {:>10} {:>10} {:>9}  {}\n", "row", "z start", "z end",
                                   "dia start", "dia end", "arc R", "role");
    double z_mm = 0;
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        const ShaftSegment& row = shaft.segments[i];
        text += fmt::format("{:>4} {:>10.3f} {:>10.3f} {:>10.4f} {:>10.4f} {:>9}  {}\n", i + 1, z_mm,
                            z_mm + row.length_mm, row.start_diameter_mm, row.end_diameter_mm,
                            row.arc_radius_mm ? fmt::format("{:.3f}", *row.arc_radius_mm) : "", visible(row.role));
        z_mm += row.length_mm;
    }
    return text + fmt::format("length {:.3f} mm, {} rows, {} bores\n", shaft.length_mm(), shaft.segments.size(),
                              shaft.bores.size());
}

void writeShaftOutputs(const Request& request, const ShaftToWrite& asked, const Progress& progress, Answer& answer)
{
    const auto wanted = [&](const char* option) -> const std::string* {
        const auto found = request.outputs.find(option);
        return found == request.outputs.end() ? nullptr : &found->second;
    };
    requireUnderstoodFor(request, answer.notes);
    if (const std::string* path = wanted(shaftOption)) io::writeFile(*path, io::shaftText(asked.shaft));
    const bool undated = isAsked(request, undatedKey);
    const bool others = std::any_of(request.outputs.begin(), request.outputs.end(),
                                    [](const auto& output) { return output.first != shaftOption; });
    if (!others) return;
    if (!asked.complete) throw Error(errors::shaftIncomplete, {{"reason", asked.missing}});
    const Notes remarks = checkShaft(asked.shaft);
    answer.notes.insert(answer.notes.end(), remarks.begin(), remarks.end());
    progress.check();
    if (const std::string* path = wanted(stockOption))
        io::writeFile(*path, io::stockText(features::outOfChuck(asked.shaft, asked.chucked_mm)));
    if (const std::string* path = wanted(tableOption)) io::writeFile(*path, cad::shaftCsv(asked.shaft));
    const bool cad = std::any_of(request.outputs.begin(), request.outputs.end(), [](const auto& output) {
        return output.first == stepOption || output.first == freecadOption || output.first == solidworksOption;
    });
    if (cad) {
        const Notes left_out = cad::cadNotes(asked.shaft);
        if (contains(left_out, notes::marksLeftOut))  // implies the other note
            std::erase_if(answer.notes, [](const Note& note) { return note.code == notes::marksFound; });
        answer.notes.insert(answer.notes.end(), left_out.begin(), left_out.end());
    }
    if (const std::string* path = wanted(stepOption)) {
        const Value* const schema = find(request.parameters, schemaKey);
        cad::StepOptions options;
        if (schema && *schema == Value(std::string("AP242"))) options.schema = cad::StepSchema::AP242;
        if (undated) options.time_stamp = std::string();
        io::writeFile(*path, cad::stepText(asked.shaft, options, progress));
    }
    const bool contour = isAsked(request, contourKey);
    if (const std::string* path = wanted(dxfOption))
        io::writeFile(*path,
                      contour ? cad::contourDxf(asked.shaft) : cad::dxfText(cad::dxfOf(drawingOf(asked, undated))));
    if (const std::string* path = wanted(drawingOption))
        io::writeFile(*path, drawing::toSvg(drawingOf(asked, undated)));
    if (const std::string* path = wanted(freecadOption)) io::writeFile(*path, cad::freecadMacro(asked.shaft));
    if (const std::string* path = wanted(solidworksOption)) io::writeFile(*path, cad::solidworksMacro(asked.shaft));
}

}  // namespace lathelier::cli
