#include "engine/form/cylinder/cylindricity_report.h"

#include <cmath>

#include "engine/core/units.h"
#include "engine/form/cylinder/cylindricity_plots.h"
#include "engine/form/cylinder/cylindricity_quantities.h"
#include "engine/form/roundness/roundness_report.h"
#include "engine/form/verify/form_verification.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::form {
namespace {

report::QuantityTable deviationsTable(const CylindricityResult& result)
{
    report::QuantityTable table = report::quantityTable(LT_TEXT("Engine", "Cylindricity"), result, {"CYLt_MZCY_um"});
    const auto add = [&table](std::vector<report::Quantity> rows) {
        for (report::Quantity& row : rows) table.rows.push_back(std::move(row));
    };
    add(report::quantityRows(result.LSCY, {"CYLt_um", "CYLp_um", "CYLv_um", "CYLq_um"}));
    if (std::isfinite(result.axis_straightness_um)) add(report::quantityRows(result, {"axis_straightness_um"}));
    add(report::quantityRows(result.LSCY, {"radius_mm"}));
    add(report::quantityRows(result, {"length_mm", "points"}));
    return table;
}

report::QuantityTable cylindricityVerdictTable(const CylindricityResult& result)
{
    report::QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    Value verdict = LT_TEXT("Engine", "none: no tolerance was given");
    if (result.verdict) verdict = name(*result.verdict);
    table.rows.push_back({LT_TEXT("Engine", "Verdict"), verdict, {}});
    if (result.parameters.tolerance_um)
        for (report::Quantity& row : report::quantityRows(result, {"tolerance_um"}))
            table.rows.push_back(std::move(row));
    return table;
}

report::Table axesTable(const CylindricityResult& result)
{
    const std::vector<FittedCylinder> cylinders{result.LSCY, result.MZCY};
    report::Table table =
        report::listTable<FittedCylinder>(LT_TEXT("Engine", "Axes"), cylinders,
                                          {"axis_point_x_mm", "axis_point_y_mm", "axis_point_z_mm", "axis_direction_x",
                                           "axis_direction_y", "axis_direction_z"});
    table.columns.insert(table.columns.begin(), LT_TEXT("Engine", "cylinder"));
    table.decimals.insert(table.decimals.begin(), 0);
    table.rows[0].insert(table.rows[0].begin(), "LSCY");
    table.rows[1].insert(table.rows[1].begin(), "MZCY");
    return table;
}

}  // namespace

report::Answer answer(const CylindricityResult& result)
{
    report::Answer answer;
    answer.quantity = "CYLt(MZCY)";
    answer.value = result.MZCY.CYLt_um;
    answer.expanded_uncertainty = result.CYLt_expanded_uncertainty_um;
    answer.unit = unit::um;
    answer.decimals = 2;
    answer.upper_limit = result.parameters.tolerance_um;
    answer.verdict = result.verdict;
    answer.sentence = LT_TEXT("Engine", "CYLt(LSCY) {value_um:2} µm · {points} points");
    answer.values = {{"value_um", result.LSCY.CYLt_um}, {"points", static_cast<std::int64_t>(result.points)}};
    return answer;
}

report::Section cylindricitySummary(const CylindricityResult& result)
{
    report::Section section{LT_TEXT("Engine", "Result"),
                            {answer(result), deviationsTable(result), cylindricityVerdictTable(result)}};
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document cylindricityReport(const CylindricityResult& result, const CylinderSurface* surface,
                                    const std::vector<InputFile>& inputs, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Cylindricity");
    document.verification = {&formVerification()};
    document.inputs = inputs;
    document.synthetic = contains(result.notes, notes::syntheticData);
    document.sections.push_back(cylindricitySummary(result));
    if (surface)
        document.sections.push_back(
            {LT_TEXT("Engine", "Surface"),
             {unrolledCylinder(*surface), radiusAlongAxis(*surface, result.parameters), centresAlongAxis(*surface)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{
              LT_TEXT("Engine",
                      "ISO 12180: CYLt is the largest minus the smallest distance of the points from the axis of "
                      "the reference cylinder. The minimum zone is locally optimal, found from several starts."),
              {}},
          axesTable(result), report::parametersTable(result.parameters, language)}});
    return document;
}

}  // namespace lathelier::form
