#include "widgets/drawing/drawing_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/cad/cad_notes.h"
#include "engine/core/json.h"
#include "engine/drawing/drawing_svg.h"
#include "engine/report/result_json.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"
#include "engine/shaft/shaft_sizes.h"
#include "widgets/part_common/drawing_words.h"
#include "widgets/part_common/part_input.h"

namespace lathelier::drawing_panel {
namespace {

void takeShaft(DrawingOutcome& outcome, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    part_common::PartInput taken = part_common::takePart(state, shaftRole, stores, progress);
    outcome.shaft = std::move(taken.shaft);
    outcome.inputs = {taken.input};
    outcome.notes = std::move(taken.notes);
    outcome.synthetic = taken.synthetic;
    outcome.recovered = std::move(taken.recovered);
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

DrawingOutcome drawingOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    DrawingOutcome outcome;
    outcome.question = fromValues<DrawingQuestion>(state.parameters);
    const DrawingQuestion& question = outcome.question;
    task::chooseSegments(question.segments, question.segments_of, state, shaftRole, outcome.shaft, outcome.notes,
                         [&](const project::Source&) {
                             takeShaft(outcome, state, stores, progress.part(0, 0.8, LT_TEXT("Engine", "Reading")));
                         });
    if (question.bores_of == boresOf(state)) outcome.shaft.bores = boresOfRows(question.bores);
    if (!question.name.empty()) outcome.shaft.name = question.name;
    receptance::chooseMaterial(question.material, outcome.shaft, outcome.notes);
    outcome.remarks = checkShaft(outcome.shaft);
    const Notes left_out = cad::cadNotes(outcome.shaft);
    outcome.remarks.insert(outcome.remarks.end(), left_out.begin(), left_out.end());
    std::erase_if(outcome.notes, [&](const Note& note) {  // notes of the file repeated by checkShaft()
        return std::any_of(outcome.remarks.begin(), outcome.remarks.end(),
                           [&](const Note& remark) { return remark.code.key == note.code.key; });
    });
    outcome.notes.insert(outcome.notes.end(), outcome.remarks.begin(), outcome.remarks.end());
    outcome.mass_kg = drawing::massInKilograms(outcome.shaft);
    return outcome;
}

drawing::Drawing drawingOf(const DrawingOutcome& outcome, const Language& language)
{
    const DrawingQuestion& question = outcome.question;
    drawing::DrawingOptions options;
    options.sheet = sheetOf(question.sheet);
    options.material = question.material_name;
    options.date = question.date.empty() ? part_common::today() : question.date;
    options.decimal_separator = part_common::decimalSeparator(language);
    options.measured = question.measured;
    options.lengths_from = question.lengths;
    if (outcome.recovered) {
        options.scan = InputFile{outcome.recovered->scan, 0, outcome.recovered->scan_sha256};
        options.method = outcome.recovered->method;
    }
    options.translate = [&language](Text english) { return text(english, language); };
    return drawing::drawShaft(outcome.shaft, options);
}

report::Answer answerOf(const DrawingOutcome& outcome)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Length");
    answer.value = outcome.shaft.length_mm();
    answer.unit = millimetre;
    const bool plain = outcome.remarks.empty();
    answer.verdict_words = plain ? LT_TEXT("Engine", "no remarks") : LT_TEXT("Engine", "with remarks");
    answer.sentence = outcome.mass_kg
                          ? LT_TEXT("Engine", "Mass {mass_kg:3} kg · largest diameter {diameter_mm:3} mm · {rows} rows")
                          : LT_TEXT("Engine",
                                    "Mass not known without a material · largest diameter {diameter_mm:3} mm · {rows} "
                                    "rows");
    answer.values = {{"mass_kg", outcome.mass_kg ? Value(*outcome.mass_kg) : Value()},
                     {"diameter_mm", largestDiameter_mm(outcome.shaft)},
                     {"rows", static_cast<std::int64_t>(outcome.shaft.segments.size())}};
    return answer;
}

report::Table rowsTable(const DrawingOutcome& outcome, const Language& language)
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
    for (const ShaftSegment& row : outcome.shaft.segments) {
        std::string tied;
        for (const std::size_t other : tiedTo(outcome.shaft.segments, static_cast<std::size_t>(number)))
            tied += (tied.empty() ? "" : ", ") + std::to_string(other + 1);
        add(std::to_string(++number), z_mm, z_mm + row.length_mm, row, tied);
        z_mm += row.length_mm;
    }
    int bores = 0;
    for (const ShaftBore& bore : outcome.shaft.bores) {
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

report::Table measuredTable(const DrawingOutcome& outcome, const Language& language)
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
    for (const ShaftSegment& row : outcome.shaft.segments) {
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

report::Table remarksTable(const DrawingOutcome& outcome, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Remarks");
    table.columns = {LT_TEXT("Engine", "Remark")};
    for (const Note& remark : outcome.remarks) table.rows.push_back({text(remark, language)});
    if (table.rows.empty())
        table.rows.push_back({text(LT_TEXT("Engine", "There is nothing to remark on this shaft."), language)});
    return table;
}

report::Document reportOf(const DrawingOutcome& outcome, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Shaft for drawing and CAD");
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    report::Section section{LT_TEXT("Engine", "Result"), {answerOf(outcome)}};
    const drawing::Drawing sheet = drawingOf(outcome, language);
    section.blocks.push_back(report::Picture{LT_TEXT("Engine", "Drawing"), drawing::toSvg(sheet)});
    section.blocks.push_back(rowsTable(outcome, language));
    if (report::Table measured = measuredTable(outcome, language); !measured.rows.empty())
        section.blocks.push_back(std::move(measured));
    if (!outcome.notes.empty()) section.blocks.push_back(outcome.notes);
    document.sections = {std::move(section)};
    Json json = {{"shaft", toJson(toValues(outcome.shaft))},
                 {"length_mm", outcome.shaft.length_mm()},
                 {"volume_mm3", volume_mm3(outcome.shaft)},
                 {"mass_kg", outcome.mass_kg ? Json(*outcome.mass_kg) : Json(nullptr)}};
    document.results = {
        report::toText(report::wholeResult("draw", outcome.inputs, toValues(outcome.question), json, outcome.notes))};
    return document;
}

}  // namespace lathelier::drawing_panel
