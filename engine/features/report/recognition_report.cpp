#include "engine/features/report/recognition_report.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/features/report/recognition_plots.h"
#include "engine/features/report/recognition_quantities.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::features {
namespace {

constexpr double mm_per_um = 1e-3;

/// "30.0004 ± 0.0006"
std::string withUncertainty(double value, std::optional<double> uncertainty, Text unit, const Language& language)
{
    const int decimals = uncertainty ? decimalsFor(*uncertainty) : 3;
    std::string text = shownNumber(value, unit, decimals, language);
    if (uncertainty) text += " ± " + shownNumber(*uncertainty, unit, decimals, language);
    return text;
}

std::optional<double> mmOf(const std::optional<double>& value_um)
{
    return value_um ? std::optional(mm_per_um * *value_um) : std::nullopt;
}

std::string descriptionOf(const RecognizedRow& row, const Language& language)
{
    std::string description = text(kindName(row.kind), language);
    if (!row.role.empty()) description += ", " + text(roleName(row.role), language);
    return description;
}

/// Of a cone and an arc from its start to its end.
std::string diameterOf(const RecognizedRow& row, const Language& language)
{
    const SizeUncertainty& u = row.uncertainty;
    std::string text = withUncertainty(row.start_diameter_mm, mmOf(u.start_diameter_um), unit::mm, language);
    if (row.kind != RowKind::Cylinder)
        text += " → " + withUncertainty(row.end_diameter_mm, mmOf(u.end_diameter_um), unit::mm, language);
    return text;
}

/// Radius of an arc or half angle of a cone.
Value shapeOf(const RecognizedRow& row, const Language& language)
{
    if (row.kind == RowKind::Arc && row.arc_radius_mm) {
        return std::string("R ").append(
            withUncertainty(std::abs(*row.arc_radius_mm), mmOf(row.uncertainty.arc_radius_um), unit::mm, language));
    }
    if (row.kind != RowKind::Cone) return {};
    const int decimals = row.uncertainty.angle_deg ? decimalsFor(*row.uncertainty.angle_deg) : 3;
    std::string angle = fixed(std::abs(row.half_angle_deg), decimals, language);
    if (row.uncertainty.angle_deg) angle += " ± " + fixed(*row.uncertainty.angle_deg, decimals, language);
    return angle + "°";
}

std::string suggestionsOf(const RecognizedRow& row, const Language& language)
{
    std::string text;
    for (const Suggestion& suggestion : row.suggestions)
        text += (text.empty() ? "" : " · ") + suggestionText(suggestion, language);
    return text;
}

report::Table marksTable(const Recognition& result, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Marks that are no body of revolution");
    table.columns = {LT_TEXT("Engine", "Mark"), report::Labelled{LT_TEXT("Engine", "z from"), unit::mm},
                     report::Labelled{LT_TEXT("Engine", "z to"), unit::mm}, LT_TEXT("Engine", "Sizes")};
    table.decimals = {0, 2, 2, 0};
    for (const ShaftMark& mark : result.marks) {
        std::string sizes = mark.designation;
        const Values values = toValues(mark);
        for (const FieldInfo& info : infos<ShaftMark>()) {
            const Value* const value = find(values, info.key);
            const auto* const number = value ? std::get_if<double>(value) : nullptr;
            if (!number || info.key == "z_start_mm" || info.key == "z_end_mm") continue;
            sizes += (sizes.empty() ? "" : " · ") + text(info.label, language) + ' ' +
                     report::cellText(*number, info.unit, 3, language) +
                     (info.unit.empty() ? "" : ' ' + text(shownUnit(info.unit, language).unit, language));
        }
        const auto given = [](const std::optional<double>& value) { return value ? Value(*value) : Value(); };
        table.rows.push_back({nameOf(mark), given(mark.z_start_mm), given(mark.z_end_mm), sizes});
    }
    return table;
}

report::Labelled fromColumn()
{
    return {LT_TEXT("Engine", "z from"), unit::mm};
}
report::Labelled toColumn()
{
    return {LT_TEXT("Engine", "z to"), unit::mm};
}

report::Table featuresTable(const Recognition& result)
{
    report::Table table{LT_TEXT("Engine", "Features"),
                        {LT_TEXT("Engine", "Feature"), fromColumn(), toColumn(), LT_TEXT("Engine", "Rows"),
                         LT_TEXT("Engine", "Designation")},
                        {},
                        {0, 3, 3, 0, 0}};
    for (const RecognizedFeature& feature : result.features)
        table.rows.push_back(
            {roleName(feature.kind), feature.z_start_mm, feature.z_end_mm, feature.rows, feature.designation});
    return table;
}

report::Table gapsTable(const Recognition& result)
{
    report::Table table{LT_TEXT("Engine", "Stretches without data"), {fromColumn(), toColumn()}, {}, {}};
    for (const Gap& gap : result.gaps) table.rows.push_back({gap.z_start_mm, gap.z_end_mm});
    return table;
}

report::Table unexplainedTable(const Recognition& result)
{
    report::Table table{LT_TEXT("Engine", "Structure that no row and no mark explains"),
                        {LT_TEXT("Engine", "Kind"), fromColumn(), toColumn(), LT_TEXT("Engine", "Places"),
                         report::Labelled{LT_TEXT("Engine", "Direction"), unit::deg},
                         report::Labelled{LT_TEXT("Engine", "Area"), LT_TEXT("Engine", "mm²")},
                         report::Labelled{LT_TEXT("Engine", "Height"), unit::mm}},
                        {},
                        {0, 1, 1, 0, 0, 1, 3}};
    const auto given = [](const std::optional<double>& value) { return value ? Value(*value) : Value(); };
    for (const UnexplainedStructure& one : result.unexplained)
        table.rows.push_back({structureName(one.kind), one.z_start_mm, one.z_end_mm, one.places, given(one.angle_deg),
                              one.area_mm2, given(one.height_mm)});
    return table;
}

report::Table endsTable(const Recognition& result)
{
    report::Table table{
        LT_TEXT("Engine", "Free end and chuck end"),
        {report::Labelled{LT_TEXT("Engine", "z"), unit::mm}, report::Labelled{LT_TEXT("Engine", "± (k = 2)"), unit::mm},
         LT_TEXT("Engine", "Closed by"), report::Labelled{LT_TEXT("Engine", "lies from"), unit::mm},
         report::Labelled{LT_TEXT("Engine", "to"), unit::mm}},
        {},
        {4, 4, 0, 3, 3}};
    for (const RecognizedEnd& end : result.ends)
        table.rows.push_back({end.z_mm, end.uncertainty_mm, endName(end.closed_by),
                              end.span_mm ? Value(end.span_mm->from) : Value(),
                              end.span_mm ? Value(end.span_mm->to) : Value()});
    return table;
}

}  // namespace

std::string suggestionText(const Suggestion& suggestion, const Language& language)
{
    std::string size = suggestion.designation;
    if (size.empty()) {
        if (suggestion.quantity == "diameter_mm") size = "⌀ ";
        if (suggestion.quantity == "radius_mm") size = "R ";
        if (suggestion.quantity == "length_mm") size = "L ";
        if (suggestion.quantity == "z_mm") size = "z ";
        const int decimals = suggestion.grid_mm >= 1 ? 0 : suggestion.grid_mm >= 0.1 ? 1 : 2;
        size += shownNumber(suggestion.nominal_mm, unit::mm, decimals, language);
    }
    std::string beside = shownNumber(suggestion.difference_um, unit::um, 1, language) + " " +
                         text(shownUnit(unit::um, language).unit, language);
    if (suggestion.difference_um > 0) beside.insert(0, 1, '+');
    if (!suggestion.tolerance.empty()) beside += ", " + suggestion.tolerance;
    if (!suggestion.agrees) beside += text(LT_TEXT("Engine", ", beyond U"), language);
    return size + " (" + beside + ")";
}

report::Table rowsTable(const Recognition& result, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Rows from the free end, ± k = 2");
    table.columns = {LT_TEXT("Engine", "Row"),
                     LT_TEXT("Engine", "Kind"),
                     report::Labelled{LT_TEXT("Engine", "Diameter"), unit::mm},
                     LT_TEXT("Engine", "Nominal"),
                     report::Labelled{LT_TEXT("Engine", "z from"), unit::mm},
                     report::Labelled{LT_TEXT("Engine", "z to"), unit::mm},
                     LT_TEXT("Engine", "R or half angle"),
                     report::Labelled{LT_TEXT("Engine", "Residual"), unit::um},
                     report::Labelled{LT_TEXT("Engine", "Form"), unit::um}};
    table.decimals = {0, 0, 0, 0, 0, 0, 0, 2, 1};
    const auto add = [&](Value number, const RecognizedRow& row) {
        const SizeUncertainty& u = row.uncertainty;
        table.rows.push_back(
            {std::move(number), descriptionOf(row, language), diameterOf(row, language), suggestionsOf(row, language),
             withUncertainty(row.z_start_mm, mmOf(u.z_start_um), unit::mm, language),
             withUncertainty(row.z_end_mm, mmOf(u.z_end_um), unit::mm, language), shapeOf(row, language),
             row.residual_um, row.form_pv_um > 0 ? Value(row.form_pv_um) : Value()});
    };
    std::int64_t number = 0;
    for (const RecognizedRow& row : result.segments) add(++number, row);
    for (std::size_t bore = 0; bore < result.bores.size(); ++bore)
        for (std::size_t i = 0; i < result.bores[bore].size(); ++i)
            add(std::string("B").append(std::to_string(bore + 1)).append(".").append(std::to_string(i + 1)),
                result.bores[bore][i]);
    return table;
}

report::Table stepsTable(const std::vector<ShaftStep>& steps)
{
    report::Table table{
        LT_TEXT("Engine", "Steps as published, chamfers folded in"),
        {report::Labelled{LT_TEXT("Engine", "x"), unit::mm}, report::Labelled{LT_TEXT("Engine", "y"), unit::mm},
         report::Labelled{LT_TEXT("Engine", "Radius"), unit::mm},
         report::Labelled{LT_TEXT("Engine", "z from"), unit::mm}, report::Labelled{LT_TEXT("Engine", "z to"), unit::mm},
         report::Labelled{LT_TEXT("Engine", "Chamfer, start"), unit::mm},
         report::Labelled{LT_TEXT("Engine", "Chamfer, end"), unit::mm}},
        {},
        {4, 4, 4, 3, 3, 3, 3}};
    for (const ShaftStep& step : steps)
        table.rows.push_back({step.x_mm, step.y_mm, step.radius_mm, step.z_start_mm, step.z_end_mm,
                              step.chamfer_start_mm, step.chamfer_end_mm});
    return table;
}

namespace {

/// Some columns of a table, for the width of a sheet; no value is parted from its uncertainty.
report::Table columnsOf(const report::Table& table, report::Caption title, std::initializer_list<std::size_t> columns)
{
    static const std::regex before(" ± ");
    report::Table part;
    part.title = std::move(title);
    for (const std::size_t column : columns) {
        part.columns.push_back(table.columns[column]);
        part.decimals.push_back(table.decimalsOf(column));
    }
    for (const std::vector<Value>& row : table.rows) {
        std::vector<Value>& cells = part.rows.emplace_back();
        for (const std::size_t column : columns) {
            const auto* cell = std::get_if<std::string>(&row[column]);
            cells.push_back(cell ? Value(std::regex_replace(*cell, before, "\u00a0±\u00a0")) : row[column]);
        }
    }
    return part;
}

}  // namespace

report::Section recognitionSummary(const Recognition& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result), rowsTable(result, language)}};
    if (!result.features.empty()) section.blocks.push_back(featuresTable(result));
    if (!result.marks.empty()) section.blocks.push_back(marksTable(result, language));
    if (!result.unexplained.empty()) section.blocks.push_back(unexplainedTable(result));
    if (!result.gaps.empty()) section.blocks.push_back(gapsTable(result));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document recognitionReport(const Recognition& result, const std::vector<ShaftStep>& steps,
                                   const std::vector<InputFile>& inputs, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Recognised part");
    document.inputs = inputs;
    document.synthetic = contains(result.notes, notes::syntheticData);
    document.sections.push_back(recognitionSummary(result, language));
    std::vector<report::Block>& blocks = document.sections.back().blocks;
    const auto rows = std::get<report::Table>(blocks[1]);
    blocks[1] = columnsOf(rows, rows.title, {0, 1, 2, 4, 5, 6});
    blocks.insert(blocks.begin() + 2,
                  columnsOf(rows, LT_TEXT("Engine", "Nominal sizes and fit of the rows"), {0, nominalColumn, 7, 8}));
    document.sections.push_back(
        {LT_TEXT("Engine", "Meridian"), {meridianPlot(result, language), residualPlot(result)}});
    report::Section fit{
        LT_TEXT("Engine", "Ends, steps and fit"),
        {report::quantityTable(LT_TEXT("Engine", "Part"), result,
                               {"length_mm", "length_uncertainty_mm", "largest_diameter_mm", "volume_mm3"}),
         endsTable(result), stepsTable(steps),
         report::quantityTable(LT_TEXT("Engine", "How well the rows describe the data"), result,
                               {"coverage_percent", "residual_rmse_mm", "chi2_per_bin", "noise_mm", "variance_ratio",
                                "passes_differ_um", "spot_mm", "points_used"})}};
    if (!result.merged.empty())
        fit.blocks.push_back(report::listTable<MergedJunction>(LT_TEXT("Engine", "Junctions within the form tolerance"),
                                                               result.merged, {"z_mm", "step_um", "angle_deg"}));
    document.sections.push_back(std::move(fit));
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{
              LT_TEXT("Engine",
                      "The points are gathered into bins of the meridian; lines and arcs with exact junctions are "
                      "fitted to all bins at once. Uncertainties are expanded (k = 2). Measured values, not a "
                      "specification."),
              {}},
          report::parametersTable(result.parameters, language)}});
    return document;
}

std::string rowsCsv(const Recognition& result)
{
    return report::csvOf<RecognizedRow>(result.segments, {"kind",
                                                          "role",
                                                          "z_start_mm",
                                                          {"uncertainty.z_start_um", "z_start_U_um"},
                                                          "z_end_mm",
                                                          {"uncertainty.z_end_um", "z_end_U_um"},
                                                          "start_diameter_mm",
                                                          {"uncertainty.start_diameter_um", "start_diameter_U_um"},
                                                          "end_diameter_mm",
                                                          {"uncertainty.end_diameter_um", "end_diameter_U_um"},
                                                          "arc_radius_mm",
                                                          {"uncertainty.arc_radius_um", "arc_radius_U_um"},
                                                          "half_angle_deg",
                                                          {"uncertainty.angle_deg", "half_angle_U_deg"},
                                                          "points",
                                                          "coverage_deg",
                                                          "residual_um",
                                                          "form_pv_um",
                                                          "taper_um"});
}

}  // namespace lathelier::features
