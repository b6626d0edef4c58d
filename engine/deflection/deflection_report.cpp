#include "engine/deflection/deflection_report.h"

#include <algorithm>

#include "engine/core/conformity.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/deflection/deflection_verification.h"
#include "engine/deflection/map_chart.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::deflection {
namespace {

/// Largest number of changed blocks listed in the report; further ones are counted.
constexpr std::size_t mostChangesShown = 400;

report::Table changesTable(const std::vector<ProgramChange>& changes, const Language& language)
{
    report::Table table{LT_TEXT("Engine", "Changed blocks"),
                        {LT_TEXT("Engine", "Line"), LT_TEXT("Engine", "Before"), LT_TEXT("Engine", "After"),
                         LT_TEXT("Engine", "Reason")},
                        {},
                        {}};
    for (const ProgramChange& change : changes) {
        if (table.rows.size() == mostChangesShown) break;
        table.rows.push_back({std::to_string(change.line),
                              change.before ? Value(*change.before) : Value(LT_TEXT("Engine", "added")), change.after,
                              fill(text(change.reason, language), change.values, language)});
    }
    return table;
}

/// Of what a correction leaves; none where neither was computed.
std::optional<double> uncertaintyOf_um(const CompensationResult& result, const ErrorBand* band)
{
    if (band) return (band->max_high_um - band->max_low_um) / 2;
    if (result.robustness.empty()) return std::nullopt;
    double largest_um = 0;
    for (const RobustnessRow& row : result.robustness) largest_um = std::max(largest_um, row.max_after_um);
    return std::max(0.0, largest_um - result.residual.max_um);
}

}  // namespace

report::Answer answer(const DeflectionResult& result, const std::optional<double>& tolerance_um,
                      const Language& language)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Largest diameter error");
    answer.value = result.summary.max_um;
    answer.unit = micrometre;
    answer.decimals = 1;
    if (tolerance_um) {
        answer.upper_limit = tolerance_um;
        answer.verdict = result.summary.max_um <= *tolerance_um ? Verdict::Pass : Verdict::Fail;
    }
    answer.sentence =
        LT_TEXT("Engine", "mean {mean} µm · range {range} µm · least with X moved by {offset} µm on diameter");
    answer.values = {{"mean", fixed(result.summary.mean_abs_um, 1, language)},
                     {"range", fixed(result.summary.range_um, 1, language)},
                     {"offset", fixed(result.summary.wear_offset_um, 1, language)}};
    return answer;
}

report::Answer answer(const CompensationResult& result, const std::optional<double>& limit_um, const ErrorBand* band,
                      const Language& language)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Largest error after the correction");
    answer.value = result.residual.max_um;
    answer.unit = micrometre;
    answer.decimals = 1;
    answer.expanded_uncertainty = uncertaintyOf_um(result, band);
    answer.upper_limit = limit_um;
    answer.verdict_words = LT_TEXT("Engine", "corrected");
    if (limit_um) {
        answer.verdict = judge(result.residual.max_um, answer.expanded_uncertainty.value_or(notANumber), *limit_um,
                               DecisionRule::Guarded);
        answer.verdict_words = {};
    }
    answer.sentence =
        LT_TEXT("Engine", "{before} µm without the correction · largest change {correction} µm on diameter");
    answer.values = {{"before", fixed(result.before.summary.max_um, 1, language)},
                     {"correction", fixed(result.largest_correction_um, 1, language)}};
    const bool is_reached = result.residual.max_um <= result.parameters.tolerance_um;
    answer.findings = {
        {LT_TEXT("Engine", "The program follows the prediction to {residual:2} µm, allowed {allowed} µm"),
         {{"residual", result.residual.max_um}, {"allowed", result.parameters.tolerance_um}},
         is_reached ? Verdict::Pass : Verdict::Fail,
         {}},
        {LT_TEXT("Engine", "{changed} blocks changed, {added} added"),
         {{"changed", result.blocks_changed}, {"added", result.blocks_added}},
         {},
         {}}};
    return answer;
}

report::Section deflectionSummary(const DeflectionResult& result, const std::optional<double>& tolerance_um,
                                  const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, tolerance_um, language)}};
    section.blocks.push_back(report::quantityTable(LT_TEXT("Engine", "Predicted diameter error"), result,
                                                   {"max_um", "mean_abs_um", "range_um", "wear_offset_um"}));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Section compensationSection(const CorrectedProgram& corrected, const std::optional<double>& limit_um,
                                    const ErrorBand* band, const Language& language)
{
    const CompensationResult& result = corrected.compensation;
    report::Section section{LT_TEXT("Engine", "Correction"),
                            {answer(result, limit_um, band, language), correctionPlot(result, language)}};
    section.blocks.push_back(changesTable(corrected.changes, language));
    if (!result.robustness.empty()) section.blocks.push_back(robustnessTable(result.robustness));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Section identificationSection(const IdentificationResult& result)
{
    report::Section section{LT_TEXT("Engine", "Stiffness from measured diameters"), {}};
    section.blocks.push_back(
        report::listTable<IdentifiedFactor>(LT_TEXT("Engine", "What was found"), result.factors,
                                            {"parameter_name", "factor", "value", "uncertainty_percent"}));
    section.blocks.push_back(diameterTable(result));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document deflectionReport(const DeflectionResult& result, const ReportParts& parts, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Deflection of the work");
    document.verification = {&deflectionVerification()};
    document.sections.push_back(deflectionSummary(result, parts.tolerance_um, language));
    ErrorPlotParts shown{
        parts.band, parts.corrected ? &parts.corrected->compensation : nullptr, parts.tolerance_um, {}};
    if (parts.identified) shown.measured = parts.identified->diameters;
    report::Section curves{LT_TEXT("Engine", "Along the work"),
                           {errorPlot(result, shown, language), depthPlot(result, language)}};
    for (const PassResult& pass : result.passes) curves.blocks.push_back(forcesPlot(pass));
    document.sections.push_back(std::move(curves));
    if (parts.corrected)
        document.sections.push_back(compensationSection(*parts.corrected, parts.tolerance_um, parts.band, language));
    if (parts.identified) document.sections.push_back(identificationSection(*parts.identified));
    report::Section other{LT_TEXT("Engine", "What if"), {}};
    if (parts.sensitivities) other.blocks.push_back(sensitivityTable(*parts.sensitivities));
    if (parts.map) other.blocks.push_back(mapChart(*parts.map, language));
    if (!other.blocks.empty()) document.sections.push_back(std::move(other));
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{
              LT_TEXT(
                  "Engine",
                  "Two equal planes of a Timoshenko beam on springs; at each place the forces of the chip and the "
                  "depth that the bent work leaves are brought to agree. Forces by chip area and length of the edge "
                  "in cut, the flow of the chip by Colwell. Vibration, heat and wear are not in it."),
              {}},
          report::parametersTable(result.setup, language)}});
    return document;
}

}  // namespace lathelier::deflection
