// Report and drawing of the task draw.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/cad/task/draw_task.h"
#include "engine/core/units.h"
#include "engine/drawing/drawing_svg.h"
#include "engine/shaft/shaft_sizes.h"

namespace lathelier::cad {
namespace {

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

drawing::Drawing drawingOf(const DrawOutcome& outcome, const Language& language)
{
    const DrawQuestion& question = outcome.question;
    drawing::DrawingOptions options = drawingOptions(question.title, question.cad, language);
    options.sheet = sheetOf(question.sheet);
    options.measured = question.measured;
    options.lengths_from = question.lengths;
    return drawing::drawShaft(outcome.shaft, options);
}

report::Answer answer(const DrawOutcome& outcome)
{
    report::Answer told;
    told.quantity = LT_TEXT("Engine", "Length");
    told.value = outcome.shaft.length_mm();
    told.unit = millimetre;
    const bool plain = outcome.remarks.empty();
    told.verdict_words = plain ? LT_TEXT("Engine", "no remarks") : LT_TEXT("Engine", "with remarks");
    told.sentence = outcome.mass_kg
                        ? LT_TEXT("Engine", "Mass {mass_kg:3} kg · largest diameter {diameter_mm:3} mm · {rows} rows")
                        : LT_TEXT("Engine",
                                  "Mass not known without a material · largest diameter {diameter_mm:3} mm · {rows} "
                                  "rows");
    told.values = {{"mass_kg", outcome.mass_kg ? Value(*outcome.mass_kg) : Value()},
                   {"diameter_mm", largestDiameter_mm(outcome.shaft)},
                   {"rows", static_cast<std::int64_t>(outcome.shaft.segments.size())}};
    return told;
}

report::Table rowsTable(const DrawOutcome& outcome, const Language& language)
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

report::Table measuredTable(const DrawOutcome& outcome, const Language& language)
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
            if (!found_mm || std::abs(*found_mm - nominal_mm) < same_mm) return;
            table.rows.push_back({number, text(name, language), nominal_mm, *found_mm, *found_mm - nominal_mm,
                                  u_um ? Value(1e-3 * *u_um) : Value()});
        };
        const SizeUncertainty& u = measured.uncertainty;
        const bool cylinder = lathelier::isCylinder(row);
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

report::Table remarksTable(const DrawOutcome& outcome, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Remarks");
    table.columns = {LT_TEXT("Engine", "Remark")};
    for (const Note& remark : outcome.remarks) table.rows.push_back({text(remark, language)});
    if (table.rows.empty())
        table.rows.push_back({text(LT_TEXT("Engine", "There is nothing to remark on this shaft."), language)});
    return table;
}

report::Document reportOf(const DrawOutcome& outcome, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Shaft for drawing and CAD");
    report::Section section{LT_TEXT("Engine", "Result"), {answer(outcome)}};
    const drawing::Drawing sheet = drawingOf(outcome, language);
    section.blocks.push_back(report::Picture{LT_TEXT("Engine", "Drawing"), drawing::toSvg(sheet)});
    section.blocks.push_back(rowsTable(outcome, language));
    if (report::Table measured = measuredTable(outcome, language); !measured.rows.empty())
        section.blocks.push_back(std::move(measured));
    if (!outcome.notes.empty()) section.blocks.push_back(outcome.notes);
    document.sections = {std::move(section)};
    return document;
}

}  // namespace lathelier::cad
