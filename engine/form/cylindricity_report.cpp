#include <cmath>

#include "engine/form/cylindricity_quantities.h"
#include "engine/form/form_verification.h"
#include "engine/form/roundness_report.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::form {
namespace {

QuantityTable deviationsTable(const CylindricityResult& result)
{
    QuantityTable table = quantityTable(LT_TEXT("Engine", "Cylindricity"), result, {"CYLt_MZCY_um"});
    const auto add = [&table](std::vector<Quantity> rows) {
        for (Quantity& row : rows) table.rows.push_back(std::move(row));
    };
    add(quantityRows(result.LSCY, {"CYLt_um", "CYLp_um", "CYLv_um", "CYLq_um"}));
    if (std::isfinite(result.axis_straightness_um)) add(quantityRows(result, {"axis_straightness_um"}));
    add(quantityRows(result.LSCY, {"radius_mm"}));
    add(quantityRows(result, {"length_mm", "points"}));
    return table;
}

QuantityTable verdictTable(const CylindricityResult& result)
{
    QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    Value verdict = LT_TEXT("Engine", "none: no tolerance was given");
    if (result.verdict) verdict = name(*result.verdict);
    table.rows.push_back({LT_TEXT("Engine", "Verdict"), verdict, {}});
    if (result.parameters.tolerance_um)
        for (Quantity& row : quantityRows(result, {"tolerance_um"})) table.rows.push_back(std::move(row));
    return table;
}

Table axesTable(const CylindricityResult& result)
{
    const std::vector<FittedCylinder> cylinders{result.LSCY, result.MZCY};
    Table table = listTable<FittedCylinder>(LT_TEXT("Engine", "Axes"), cylinders,
                                            {"axis_point_x_mm", "axis_point_y_mm", "axis_point_z_mm",
                                             "axis_direction_x", "axis_direction_y", "axis_direction_z"});
    table.columns.insert(table.columns.begin(), LT_TEXT("Engine", "cylinder"));
    table.decimals.insert(table.decimals.begin(), 0);
    table.rows[0].insert(table.rows[0].begin(), "LSCY");
    table.rows[1].insert(table.rows[1].begin(), "MZCY");
    return table;
}

}  // namespace

Headline headline(const CylindricityResult& result, const Language& language)
{
    Headline answer;
    answer.text = "CYLt(MZCY) " + fixed(result.MZCY.CYLt_um, 2, language) + " µm · CYLt(LSCY) " +
                  fixed(result.LSCY.CYLt_um, 2, language) + " µm";
    answer.text = keptTogether(answer.text);
    if (!result.verdict || !result.parameters.tolerance_um) return answer;
    const Text words = *result.verdict == Verdict::Pass   ? LT_TEXT("Engine", "within {tolerance} µm")
                       : *result.verdict == Verdict::Fail ? LT_TEXT("Engine", "above {tolerance} µm")
                                                          : LT_TEXT("Engine", "? not decided at {tolerance} µm");
    answer.text +=
        keptTogether(" · " + fill(text(words, language), {{"tolerance", *result.parameters.tolerance_um}}, language));
    answer.verdict = passed(result.verdict);
    return answer;
}

Section cylindricitySummary(const CylindricityResult& result, const Language& language)
{
    Section section{LT_TEXT("Engine", "Result"),
                    {headline(result, language), deviationsTable(result), verdictTable(result)}};
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

Document cylindricityReport(const CylindricityResult& result, const std::vector<InputFile>& inputs,
                            const Language& language)
{
    Document document;
    document.title = LT_TEXT("Engine", "Cylindricity");
    document.verification = {&formVerification()};
    document.inputs = inputs;
    document.synthetic = contains(result.notes, notes::syntheticData);
    document.sections = {
        cylindricitySummary(result, language),
        {LT_TEXT("Engine", "Method and parameters"),
         {Paragraph{LT_TEXT("Engine",
                            "ISO 12180: CYLt is the largest minus the smallest distance of the points from the axis of "
                            "the reference cylinder. The minimum zone is locally optimal, found from several starts."),
                    {}},
          axesTable(result), parametersTable(result.parameters, language)}}};
    return document;
}

}  // namespace lathelier::form
