#include "engine/stability/stability_report.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/stability/depth_digits.h"
#include "engine/stability/operating_point.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_verification.h"

namespace lathelier::stability {
namespace {

report::Section methodSection(SpeedRelation relation, report::QuantityTable parameters)
{
    const Text words =
        relation == SpeedRelation::Exact
            ? LT_TEXT("Engine",
                      "Regenerative chatter of a single-point cut: the limiting depth is -1/(2 K_r Re G) of the "
                      "oriented receptance G; its speeds are 60 f/(k + ε/2π), ε = 3π + 2 arg G, k = 0, 1, 2 …")
            : LT_TEXT("Engine",
                      "Regenerative chatter of a single-point cut by the published relation: the limiting depth is "
                      "-1/(2 K_r Re G), its speeds are 60 f/k; the phase of the regeneration is set to zero.");
    return {LT_TEXT("Engine", "Method and parameters"), {report::Paragraph{words, {}}, std::move(parameters)}};
}

report::Section responseSection(const Frf& frf, std::optional<double> least_hz, const Language& language)
{
    return {LT_TEXT("Engine", "Frequency response"),
            {receptance::magnitudePlot(frf), receptance::realImaginaryPlot(frf, least_hz, language)}};
}

report::QuantityTable ruleTable(const SpeedResult& result)
{
    return report::quantityTable(LT_TEXT("Engine", "Spindle speed"), result,
                                 {"selected_rpm", "recommended_rpm", "recommended_cutting_speed_m_min", "frequency_hz",
                                  "lobe.k", "lobe.low_rpm", "lobe.high_rpm"});
}

/// The speed by depth, then that of the papers' rule, which knows no depth.
void addSpeedSections(report::Document& document, const LobesMarks& marks, bool is_relative)
{
    if (marks.safe)
        document.sections.push_back({LT_TEXT("Engine", "Stable speeds"), {pocketsTable(*marks.safe, is_relative)}});
    if (marks.rule)
        document.sections.push_back({LT_TEXT("Engine", "By the rule of the papers, which knows no depth"),
                                     {ruleTable(*marks.rule), candidatesTable(*marks.rule)}});
}

}  // namespace

report::Table pocketsTable(const SafeSpeed& safe, bool is_relative)
{
    const auto depth = [&](Text label) {
        return is_relative ? report::Caption(label) : report::Caption(report::Labelled{label, unit::mm});
    };
    report::Table table;
    table.title = LT_TEXT("Engine", "Stable speeds of the range, the deepest first");
    table.columns = {
        report::Labelled{LT_TEXT("Engine", "Spindle speed"), unit::rpm},
        depth(is_relative ? LT_TEXT("Engine", "Limit, in multiples of the least") : LT_TEXT("Engine", "Limit")),
        depth(LT_TEXT("Engine", "Margin")), LT_TEXT("Engine", "Stable at the depth")};
    double least = HUGE_VAL;
    for (const DepthAtSpeed& peak : safe.peaks)
        if (peak.limit) least = std::min(least, *peak.limit);
    table.decimals = {0, depthDecimals(least), depthDecimals(least)};
    const auto cell = [](const std::optional<double>& value) { return value ? Value(*value) : Value(); };
    for (const DepthAtSpeed& peak : safe.peaks)
        table.rows.push_back({peak.speed_rpm, cell(peak.limit), cell(peak.margin), peak.is_stable});
    return table;
}

report::Table candidatesTable(const SpeedResult& result)
{
    return report::listTable<SpeedCandidate>(LT_TEXT("Engine", "Stable speeds, one for each lobe"), result.candidates,
                                             {"k", "speed_rpm", "in_range"});
}

report::Answer answer(const LobeResult& result, const Language& language)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Depth that is stable at every speed");
    answer.verdict_words = LT_TEXT("Engine", "computed");
    if (!result.minimum_depth_mm) {
        answer.sentence = result.parameters.process_damping_N_mm
                              ? LT_TEXT("Engine", "Nothing chatters at the speeds shown.")
                              : LT_TEXT("Engine", "Nothing chatters: the real part is nowhere negative.");
        return answer;
    }
    answer.decimals = depthDecimals(result.isRelative() ? 1 : *result.minimum_depth_mm);
    answer.values = {{"frequency", fixed(*result.frequency_of_minimum_hz, 1, language)},
                     {"lobes", static_cast<std::int64_t>(result.lobes_in_range)}};
    if (result.isRelative()) {
        answer.sentence = LT_TEXT(
            "Engine",
            "Depths are multiples of the least limit, for K_r is not given · chatter at {frequency} Hz · lobes in "
            "the range: {lobes}");
        return answer;
    }
    answer.value = result.minimum_depth_mm;
    if (result.minimum_noise_percent)
        answer.expanded_uncertainty = 2 * *result.minimum_noise_percent / 100 * *result.minimum_depth_mm;
    answer.unit = unit::mm;
    answer.sentence = LT_TEXT("Engine", "Chatter at {frequency} Hz · lobes in the range: {lobes}");
    return answer;
}

report::Answer answer(const SpeedResult& result, const Language& language)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Recommended spindle speed");
    answer.verdict_words = LT_TEXT("Engine", "recommended");
    answer.value = result.recommended_rpm;
    answer.unit = unit::rpm;
    answer.decimals = 0;
    answer.sentence =
        std::isfinite(result.recommended_cutting_speed_m_min)
            ? LT_TEXT("Engine", "Instead of {selected} · {cutting_speed} m/min · f_m {frequency} Hz · lobe {k}")
            : LT_TEXT("Engine", "Instead of {selected} · f_m {frequency} Hz · lobe {k}");
    answer.values = {{"selected", fixed(result.selected_rpm, 0, language)},
                     {"cutting_speed", fixed(result.recommended_cutting_speed_m_min, 0, language)},
                     {"frequency", fixed(result.frequency_hz, 1, language)},
                     {"k", std::int64_t{result.k}}};
    return answer;
}

report::Section lobesSummary(const LobeResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language)}};
    report::QuantityTable table =
        report::quantityTable(LT_TEXT("Engine", "Stability"), result, {"minimum_depth_mm", "frequency_of_minimum_hz"});
    if (result.minimum_noise_percent)
        table.rows.push_back(report::quantityRows(result, {"minimum_noise_percent"}).front());
    section.blocks.emplace_back(std::move(table));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Section speedSummary(const SpeedResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language)}};
    section.blocks.push_back(ruleTable(result));
    section.blocks.push_back(candidatesTable(result));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document lobesReport(const LobeResult& result, const Frf& frf, const LobesMarks& marks, const UsedValues& used,
                             const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Stability of cutting");
    document.verification = {&stabilityVerification()};
    document.sections.push_back(lobesSummary(result, language));
    std::get<report::Answer>(document.sections.back().blocks.front()).used = used;
    if (marks.point) document.sections.back().blocks.push_back(pointTable(result, *marks.point));
    document.sections.push_back(
        {LT_TEXT("Engine", "Lobes"), {lobesPlot(result, marks, language), chatterFrequencyPlot(result)}});
    addSpeedSections(document, marks, result.isRelative());
    document.sections.push_back(responseSection(frf, result.frequency_of_minimum_hz, language));
    document.sections.push_back(
        methodSection(result.parameters.relation, report::parametersTable(result.parameters, language)));
    return document;
}

report::Document speedReport(const SpeedResult& result, const LobeResult& near, const Frf& frf, const LobesMarks& marks,
                             const UsedValues& used, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Spindle speed without chatter");
    document.verification = {&stabilityVerification()};
    document.sections.push_back(speedSummary(result, language));
    std::get<report::Answer>(document.sections.back().blocks.front()).used = used;
    document.sections.push_back({LT_TEXT("Engine", "Lobes"), {lobesPlot(near, marks, language)}});
    if (marks.safe)
        document.sections.push_back({LT_TEXT("Engine", "Stable speeds"), {pocketsTable(*marks.safe, false)}});
    document.sections.push_back(responseSection(frf, result.frequency_hz, language));
    document.sections.push_back(
        methodSection(result.parameters.relation, report::parametersTable(result.parameters, language)));
    return document;
}

}  // namespace lathelier::stability
