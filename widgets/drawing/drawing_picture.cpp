#include "widgets/drawing/drawing_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/cad/cad_notes.h"
#include "engine/core/json.h"
#include "engine/core/shaft_contour.h"
#include "engine/core/shaft_rules.h"
#include "engine/core/shaft_sizes.h"
#include "engine/drawing/drawing_svg.h"
#include "engine/report/result_json.h"
#include "widgets/part_common/drawing_words.h"
#include "widgets/part_common/taken_part.h"

namespace lathelier::drawing_panel {
namespace {

void takeShaft(DrawingPicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    part_common::TakenPart taken = part_common::takePart(state, shaftRole, stores, progress);
    picture.shaft = std::move(taken.shaft);
    picture.inputs = {taken.input};
    picture.notes = std::move(taken.notes);
    picture.synthetic = taken.synthetic;
    picture.recovered = std::move(taken.recovered);
}

std::optional<drawing::Sheet> sheetOf(SheetChoice choice)
{
    switch (choice) {
        case SheetChoice::A4: return drawing::Sheet::A4Landscape;
        case SheetChoice::A4Portrait: return drawing::Sheet::A4Portrait;
        case SheetChoice::A3: return drawing::Sheet::A3Landscape;
        case SheetChoice::Automatic: break;
    }
    return std::nullopt;
}

double largestDiameter_mm(const Shaft& shaft)
{
    double largest_mm = 0;
    for (const ShaftSegment& row : shaft.segments)
        largest_mm = std::max({largest_mm, row.start_diameter_mm, row.end_diameter_mm});
    return largest_mm;
}

}  // namespace

DrawingPicture drawingPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    DrawingPicture picture;
    picture.question = fromValues<DrawingQuestion>(state.parameters);
    const DrawingQuestion& question = picture.question;
    part_common::chooseSegments(
        question.segments, question.segments_of, state, picture.shaft, picture.notes, [&](const project::Source&) {
            takeShaft(picture, state, stores, progress.part(0, 0.8, LT_TEXT("Engine", "Reading")));
        });
    if (question.bores_of == boresOf(state)) picture.shaft.bores = boresOfRows(question.bores);
    if (!question.name.empty()) picture.shaft.name = question.name;
    part_common::chooseMaterial(question.material, picture.shaft, picture.notes);
    picture.remarks = checkShaft(picture.shaft);
    const Notes left_out = cad::cadNotes(picture.shaft);
    picture.remarks.insert(picture.remarks.end(), left_out.begin(), left_out.end());
    std::erase_if(picture.notes, [&](const Note& note) {  // of the file: said again
        return std::any_of(picture.remarks.begin(), picture.remarks.end(),
                           [&](const Note& remark) { return remark.code.key == note.code.key; });
    });
    picture.notes.insert(picture.notes.end(), picture.remarks.begin(), picture.remarks.end());
    picture.mass_kg = drawing::massInKilograms(picture.shaft);
    return picture;
}

drawing::Drawing drawingOf(const DrawingPicture& picture, const Language& language)
{
    const DrawingQuestion& question = picture.question;
    drawing::DrawingOptions options;
    options.sheet = sheetOf(question.sheet);
    options.material = question.material_name;
    options.date = question.date.empty() ? part_common::today() : question.date;
    options.decimal_separator = part_common::decimalSeparator(language);
    options.measured = question.measured;
    options.lengths_from = question.lengths;
    if (picture.recovered) {
        options.scan = InputFile{picture.recovered->scan, 0, picture.recovered->scan_sha256};
        options.method = picture.recovered->method;
    }
    options.translate = [&language](Text english) { return text(english, language); };
    return drawing::drawShaft(picture.shaft, options);
}

report::Answer answerOf(const DrawingPicture& picture)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Length");
    answer.value = picture.shaft.length_mm();
    answer.unit = millimetre;
    const bool plain = picture.remarks.empty();
    answer.verdict_words = plain ? LT_TEXT("Engine", "no remarks") : LT_TEXT("Engine", "with remarks");
    answer.sentence = picture.mass_kg
                          ? LT_TEXT("Engine", "Mass {mass_kg:3} kg · largest diameter {diameter_mm:3} mm · {rows} rows")
                          : LT_TEXT("Engine",
                                    "Mass not known without a material · largest diameter {diameter_mm:3} mm · {rows} "
                                    "rows");
    answer.values = {{"mass_kg", picture.mass_kg ? Value(*picture.mass_kg) : Value()},
                     {"diameter_mm", largestDiameter_mm(picture.shaft)},
                     {"rows", static_cast<std::int64_t>(picture.shaft.segments.size())}};
    return answer;
}

report::Table rowsTable(const DrawingPicture& picture, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Rows from the free end");
    table.columns = {LT_TEXT("Engine", "Row"),
                     LT_TEXT("Engine", "Kind"),
                     report::Labelled{LT_TEXT("Engine", "z from"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "z to"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "Length"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "Start ⌀"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "End ⌀"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "Arc radius"), millimetre},
                     LT_TEXT("Engine", "Role"),
                     LT_TEXT("Engine", "Same ⌀ as")};
    table.decimals = {0, 0, 3, 3, 3, 3, 3, 3, 0, 0};
    const auto add = [&](std::string number, double from_mm, double to_mm, const auto& row, const std::string& tied) {
        const Text kind = row.arc_radius_mm                              ? LT_TEXT("Engine", "arc")
                          : row.start_diameter_mm == row.end_diameter_mm ? LT_TEXT("Engine", "cylinder")
                                                                         : LT_TEXT("Engine", "cone");
        const Value arc_radius = row.arc_radius_mm ? Value(*row.arc_radius_mm) : Value();
        table.rows.push_back({std::move(number), text(kind, language), from_mm, to_mm, row.length_mm,
                              row.start_diameter_mm, row.end_diameter_mm, arc_radius, row.role, tied});
    };
    double z_mm = 0;
    int number = 0;
    for (const ShaftSegment& row : picture.shaft.segments) {
        std::string tied;
        for (const std::size_t other : tiedTo(picture.shaft.segments, static_cast<std::size_t>(number)))
            tied += (tied.empty() ? "" : ", ") + std::to_string(other + 1);
        add(std::to_string(++number), z_mm, z_mm + row.length_mm, row, tied);
        z_mm += row.length_mm;
    }
    int bores = 0;
    for (const ShaftBore& bore : picture.shaft.bores) {
        const double sense = bore.from == ShaftEnd::Free ? 1 : -1;
        double at_mm = sense > 0 ? 0 : z_mm;
        ++bores;
        for (std::size_t i = 0; i < bore.segments.size(); ++i) {
            const double end_mm = at_mm + sense * bore.segments[i].length_mm;
            add(fmt::format("B{}.{}", bores, i + 1), at_mm, end_mm, bore.segments[i], {});
            at_mm = end_mm;
        }
    }
    return table;
}

report::Table measuredTable(const DrawingPicture& picture, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Measured − nominal");
    table.columns = {LT_TEXT("Engine", "Row"),
                     LT_TEXT("Engine", "Size"),
                     report::Labelled{LT_TEXT("Engine", "Nominal"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "Measured"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "Measured − nominal"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "U"), millimetre}};
    table.decimals = {0, 0, 3, 4, 4, 4};
    std::int64_t number = 0;
    for (const ShaftSegment& row : picture.shaft.segments) {
        ++number;
        if (!row.measured) continue;
        const MeasuredSize& measured = *row.measured;
        const auto add = [&](Text name, double nominal_mm, const std::optional<double>& found_mm,
                             const std::optional<double>& u_um) {
            if (!found_mm) return;
            table.rows.push_back({number, text(name, language), nominal_mm, *found_mm, *found_mm - nominal_mm,
                                  u_um ? Value(1e-3 * *u_um) : Value()});
        };
        const SizeUncertainty& u = measured.uncertainty;
        const bool cylinder = isCylinder(row);
        add(cylinder ? LT_TEXT("Engine", "diameter") : LT_TEXT("Engine", "diameter at the start"),
            row.start_diameter_mm, measured.start_diameter_mm, u.start_diameter_um);
        if (!cylinder)
            add(LT_TEXT("Engine", "diameter at the end"), row.end_diameter_mm, measured.end_diameter_mm,
                u.end_diameter_um);
        add(LT_TEXT("Engine", "length"), row.length_mm, measured.length_mm, u.length_um);
        if (row.arc_radius_mm)
            add(LT_TEXT("Engine", "radius"), std::abs(*row.arc_radius_mm),
                measured.arc_radius_mm ? std::optional(std::abs(*measured.arc_radius_mm)) : std::nullopt,
                u.arc_radius_um);
    }
    return table;
}

report::Table remarksTable(const DrawingPicture& picture, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Remarks");
    table.columns = {LT_TEXT("Engine", "Remark")};
    for (const Note& remark : picture.remarks) table.rows.push_back({text(remark, language)});
    if (table.rows.empty())
        table.rows.push_back({text(LT_TEXT("Engine", "There is nothing to remark on this shaft."), language)});
    return table;
}

report::Document reportOf(const DrawingPicture& picture, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Shaft for drawing and CAD");
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    report::Section section{LT_TEXT("Engine", "Result"), {answerOf(picture)}};
    const drawing::Drawing sheet = drawingOf(picture, language);
    section.blocks.push_back(report::Picture{LT_TEXT("Engine", "Drawing"), drawing::toSvg(sheet)});
    section.blocks.push_back(rowsTable(picture, language));
    if (report::Table measured = measuredTable(picture, language); !measured.rows.empty())
        section.blocks.push_back(std::move(measured));
    if (!picture.notes.empty()) section.blocks.push_back(picture.notes);
    document.sections = {std::move(section)};
    Json json = {{"shaft", toJson(toValues(picture.shaft))},
                 {"length_mm", picture.shaft.length_mm()},
                 {"volume_mm3", volume_mm3(picture.shaft)},
                 {"mass_kg", picture.mass_kg ? Json(*picture.mass_kg) : Json(nullptr)}};
    document.results = {
        report::toText(report::wholeResult("draw", picture.inputs, toValues(picture.question), json, picture.notes))};
    return document;
}

}  // namespace lathelier::drawing_panel
