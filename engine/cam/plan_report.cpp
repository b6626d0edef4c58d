#include "engine/cam/plan_report.h"

#include <nlohmann/json.hpp>

#include "engine/cam/check/check_quantities.h"
#include "engine/cam/check/check_report.h"
#include "engine/cam/plan_quantities.h"
#include "engine/core/units.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::cam {
namespace {

double timeOf(const TurningPlan& plan)
{
    double time = 0;
    for (const SetupPlan& setup : plan.setups) time += setup.time_s;
    return time;
}

std::size_t findingCount(const TurningPlan& plan)
{
    std::size_t count = 0;
    for (const SetupPlan& setup : plan.setups) count += setup.check.findings.size();
    return count;
}

}  // namespace

report::Answer answer(const TurningPlan& plan, const Language&)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Most that is left on the drawing");
    answer.value = plan.left_max_mm;
    answer.unit = unit::mm;
    answer.decimals = 4;
    answer.verdict = plan.verdict;
    answer.verdict_words = plan.is_refused          ? LT_TEXT("Engine", "✗ the program is refused")
                           : !plan.rest.empty()     ? LT_TEXT("Engine", "✗ material stays")
                           : !plan.not_made.empty() ? LT_TEXT("Engine", "✗ not all that is drawn is made")
                                                    : LT_TEXT("Engine", "✓ as drawn");
    answer.sentence =
        plan.not_made.empty()
            ? LT_TEXT("Engine",
                      "{setups} clamping(s) · {time_min:1} min · gouge {gouge_um:2} µm · findings: {findings} · "
                      "places with material left: {rest}")
            : LT_TEXT("Engine",
                      "{setups} clamping(s) · {time_min:1} min · gouge {gouge_um:2} µm · findings: {findings} · "
                      "places with material left: {rest} · drawn, but not in the program: {not_made} ({feature})");
    answer.values = {{"setups", static_cast<std::int64_t>(plan.setups.size())},
                     {"time_min", timeOf(plan) / 60},
                     {"gouge_um", plan.worstCheck().gouge_um},
                     {"findings", static_cast<std::int64_t>(findingCount(plan))},
                     {"rest", static_cast<std::int64_t>(plan.rest.size())}};
    if (!plan.not_made.empty()) {
        set(answer.values, "not_made", static_cast<std::int64_t>(plan.not_made.size()));
        set(answer.values, "feature", nameOf(plan.not_made.front()));
    }
    return answer;
}

report::Plot meridianPlot(const TurningPlan& plan, std::size_t setup, const Language& language)
{
    const SetupPlan& shown = plan.setups.at(setup);
    report::Plot plot = meridianPlot(shown.check, plan.part, language);
    std::int64_t number = 0;
    for (const RestInterval& rest : plan.rest) {
        double from = rest.z_start_mm, to = rest.z_end_mm;
        if (shown.clamping.is_mirrored) {
            from = plan.part.length_mm() - rest.z_end_mm;
            to = plan.part.length_mm() - rest.z_start_mm;
        }
        plot.regions.push_back(report::stretch(std::to_string(++number),
                                               {from + shown.check.stock_zero_mm, to + shown.check.stock_zero_mm},
                                               report::ColourRole::Excess));
    }
    return plot;
}

report::Table operationTable(const SetupPlan& setup)
{
    return report::listTable<PlannedOperation>(
        LT_TEXT("Engine", "Operations"), setup.operations,
        {"kind_name", "tool", "blocks", "first_line", "feed_length_mm", "time_s", "volume_cm3", "power_max_kW"});
}

report::Table restTable(const TurningPlan& plan)
{
    return report::listTable<RestInterval>(LT_TEXT("Engine", "What stays on the drawing"), plan.rest,
                                           {"z_start_mm", "z_end_mm", "left_mm", "cause_name", "tool"});
}

report::Table notMadeTable(const TurningPlan& plan)
{
    return report::listTable<DrawnFeature>(LT_TEXT("Engine", "Drawn, but not in the program"), plan.not_made,
                                           {"feature", "z_start_mm", "z_end_mm", "diameter_mm", "designation"});
}

report::Table sectionTable(const TurningPlan& plan)
{
    return report::listTable<SectionSpeed>(LT_TEXT("Engine", "Speeds of the finish"), plan.sections,
                                           {"setup", "z_start_mm", "z_end_mm", "diameter_mm", "speed_rpm",
                                            "cutting_speed_m_min", "frequency_hz", "lobe", "reason", "Rz_um"});
}

report::Table toolTable(const TurningPlan& plan)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Tools");
    table.columns = {LT_TEXT("Engine", "Tool"), LT_TEXT("Engine", "Use"), LT_TEXT("Engine", "Name"),
                     report::Labelled{LT_TEXT("Engine", "Radius"), unit::mm},
                     report::Labelled{LT_TEXT("Engine", "Width"), unit::mm}};
    for (const JobTool& tool : plan.job.tools) {
        const std::optional<double>& across_mm = tool.isDrill() ? tool.diameter_mm : tool.width_mm;
        table.rows.push_back({std::int64_t{tool.number}, nameOf(tool.use), tool.name,
                              tool.isDrill() ? Value() : Value(tool.radius_mm()),
                              across_mm ? Value(*across_mm) : Value()});
    }
    return table;
}

report::Section planSummary(const TurningPlan& plan, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Turning program"), {answer(plan, language)}};
    if (!plan.rest.empty()) section.blocks.push_back(restTable(plan));
    if (!plan.not_made.empty()) section.blocks.push_back(notMadeTable(plan));
    for (const SetupPlan& setup : plan.setups) section.blocks.push_back(operationTable(setup));
    if (!plan.sections.empty()) section.blocks.push_back(sectionTable(plan));
    for (const SetupPlan& setup : plan.setups)
        if (!setup.check.findings.empty()) section.blocks.push_back(findingTable(setup.check));
    return section;
}

report::Document planReport(const TurningPlan& plan, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Turning program");
    document.sections.push_back({LT_TEXT("Engine", "Result"), {answer(plan, language)}});
    report::Section& result = document.sections.back();
    if (!plan.rest.empty()) result.blocks.push_back(restTable(plan));
    if (!plan.not_made.empty()) result.blocks.push_back(notMadeTable(plan));
    result.blocks.push_back(sectionTable(plan));
    if (!plan.notes.empty()) result.blocks.emplace_back(plan.notes);
    for (std::size_t i = 0; i < plan.setups.size(); ++i) {
        const SetupPlan& setup = plan.setups[i];
        report::Section section;
        section.title = i == 0 ? LT_TEXT("Engine", "First clamping") : LT_TEXT("Engine", "Second clamping");
        section.blocks.push_back(operationTable(setup));
        if (!setup.check.findings.empty()) section.blocks.push_back(findingTable(setup.check));
        if (setup.check.stock) section.blocks.push_back(meridianPlot(plan, i, language));
        document.sections.push_back(std::move(section));
    }
    document.sections.push_back({LT_TEXT("Engine", "Set-up sheet"), {toolTable(plan)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Parameters"), {report::parametersTable(plan.parameters, language)}});
    return document;
}

Json toJson(const TurningPlan& plan)
{
    return nestedJson(describedValues(plan));
}

}  // namespace lathelier::cam
