#include "engine/trajectory/trajectory_report.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/form/roundness/roundness_plots.h"
#include "engine/form/roundness/roundness_report.h"
#include "engine/form/verify/form_verification.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/trajectory/channel_map.h"
#include "engine/trajectory/trajectory_plots.h"
#include "engine/trajectory/trajectory_quantities.h"

namespace lathelier::trajectory {
namespace {

report::QuantityTable longitudinalTable(const LongitudinalSection& section)
{
    return report::quantityTable(LT_TEXT("Engine", "Longitudinal section"), section,
                                 {"taper_diameter_um", "barrel_um", "diameter_range_um", "half_diameter_range_um",
                                  "axis_straightness_um", "profile_straightness_um", "CYLt_LSCY_um", "CYLt_MZCY_um"});
}

report::QuantityTable worstTable(const TrajectorySection& section, const TrajectoryResult& result)
{
    report::QuantityTable table = report::quantityTable(
        LT_TEXT("Engine", "The section with the largest deviation"), section,
        {"section", "z_mm", "RONt_MZCI_um", "RONt_LSCI_um", "RONt_MICI_um", "RONt_MCCI_um",
         "RONt_expanded_uncertainty_um", "run_out_um", "two_point.range_um", "two_point.half_range_um"});
    if (result.parameters.form.tolerance_um)
        for (report::Quantity& row : report::quantityRows(section, {"tolerance_um"}))
            table.rows.push_back(std::move(row));
    if (result.verdict) table.rows.push_back({LT_TEXT("Engine", "Verdict"), name(*result.verdict), {}});
    return table;
}

/// With every reference circle.
report::Table allSectionsTable(const TrajectoryResult& result)
{
    std::vector<const char*> keys{
        "section",      "z_mm",         "diameter_mm",        "RONt_MZCI_um", "RONt_LSCI_um",
        "RONt_MICI_um", "RONt_MCCI_um", "two_point.range_um", "run_out_um",   "revolutions_used"};
    if (result.parameters.form.tolerance_um) keys.push_back("judged");
    return report::listTable<TrajectorySection>(LT_TEXT("Engine", "All sections"), result.sections, keys);
}

report::Table errorMotionTable(const TrajectorySection& section)
{
    std::vector<ErrorMotion> motions(section.error_motion.begin(), section.error_motion.end());
    if (section.rotating) motions.push_back(*section.rotating);
    report::Table table =
        report::listTable<ErrorMotion>(LT_TEXT("Engine", "Error motion (ISO 230-7), without mean and eccentricity"),
                                       motions, {"synchronous_um", "asynchronous_um", "total_um"});
    table.columns = {LT_TEXT("Engine", "signal"), report::Labelled{LT_TEXT("Engine", "synchronous"), unit::um},
                     report::Labelled{LT_TEXT("Engine", "asynchronous"), unit::um},
                     report::Labelled{LT_TEXT("Engine", "total"), unit::um}, LT_TEXT("Engine", "drift (µm/rev)")};
    table.decimals = {0, 2, 2, 2, 4};
    for (std::size_t probe = 0; probe < table.rows.size(); ++probe) {
        std::vector<Value>& row = table.rows[probe];
        const bool single = probe < section.error_motion.size();
        const bool known = single && !section.revolutions_um[probe].empty();  // averages do not determine the drift
        row.insert(row.begin(), single ? Value(std::string(name(static_cast<Probe>(probe))))
                                       : Value(LT_TEXT("Engine", "rotating direction")));
        row.push_back(known ? Value(section.drift_um_per_rev[probe]) : Value());
    }
    return table;
}

report::QuantityTable cuttingTable(const TrajectoryResult& result, const Language& language)
{
    report::QuantityTable table{LT_TEXT("Engine", "Cutting data, as the record states them"), {}};
    for (const auto& [key, value] : result.cutting) table.rows.push_back({key, text(value, language), {}});
    return table;
}

report::Section alongSection(const TrajectoryResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Along the workpiece"), {}};
    if (result.longitudinal) section.blocks.push_back(longitudinalPlot(*result.longitudinal, language));
    if (result.sections.size() > 1) section.blocks.push_back(roundnessAlongAxis(result));
    section.blocks.push_back(allSectionsTable(result));
    return section;
}

report::Section motionSection(const TrajectorySection& worst, double workpiece_diameter_mm, const Language& language)
{
    report::Section section{
        LT_TEXT("Engine", "Motion of spindle and tool in that section"),
        {trajectoryPlot(worst, language), envelopePlot(worst),
         errorMotionPlot(worst, workpiece_diameter_mm, Probe::X3, language), errorMotionTable(worst)}};
    if (!worst.revolution_RONt_um.empty()) {
        double least = HUGE_VAL, most = 0;
        for (const double value : worst.revolution_RONt_um) {
            least = std::fmin(least, value);
            most = std::fmax(most, value);
        }
        section.blocks.push_back(report::Paragraph{
            LT_TEXT("Engine",
                    "The images of single revolutions have RONt(LSCI) from {least_um:2} to {most_um:2} µm; their mean "
                    "hides what differs from turn to turn."),
            {{"least_um", least}, {"most_um", most}}});
    }
    return section;
}

}  // namespace

report::Answer motionAnswer(const TrajectoryResult& result, const TrajectorySection& section)
{
    report::Answer answer;
    answer.used = result.used;
    const ErrorMotion& motion = section.spindle;
    const bool has_total = std::isfinite(motion.total_um);
    answer.quantity = has_total ? LT_TEXT("Engine", "Motion of the workpiece axis")
                                : LT_TEXT("Engine", "Motion that repeats with every turn");
    answer.value = has_total ? motion.total_um : motion.synchronous_um;
    answer.unit = unit::um;
    answer.decimals = 1;
    if (const double U_um =
            has_total ? motion.total_expanded_uncertainty_um : motion.synchronous_expanded_uncertainty_um;
        std::isfinite(U_um)) {
        answer.expanded_uncertainty = U_um;
        answer.decimals = form::decimalsFor(U_um);
    }
    answer.values = {{"turns", std::int64_t{section.revolutions_used}}};
    if (!has_total) {
        answer.sentence = LT_TEXT("Engine", "Only averages of {turns} turns are known · probe X3");
        return answer;
    }
    answer.sentence =
        LT_TEXT("Engine",
                "Repeats with every turn {synchronous_um:1} µm, differs from turn to turn {asynchronous_um:1} µm · "
                "{turns} turns · probe X3");
    answer.values = {{"synchronous_um", motion.synchronous_um},
                     {"asynchronous_um", motion.asynchronous_um},
                     {"turns", std::int64_t{section.revolutions_used}}};
    return answer;
}

report::Answer answer(const TrajectoryResult& result, const Language& language)
{
    report::Answer answer;
    answer.used = result.used;
    answer.quantity = "RONt(" + std::string(name(result.parameters.form.circle)) + ")";
    answer.unit = unit::um;
    answer.decimals = 1;
    answer.upper_limit = result.parameters.form.tolerance_um;
    answer.verdict = result.verdict;
    const auto worst = result.worstSection();
    if (!worst) return answer;
    const TrajectorySection& section = result.sections[*worst];
    answer.value = headlineDeviation_um(section.roundness);
    answer.expanded_uncertainty = section.roundness.RONt_expanded_uncertainty_um;
    answer.decimals = form::decimalsFor(*answer.expanded_uncertainty);
    answer.values = {{"section", std::int64_t{section.section}},
                     {"count", static_cast<std::int64_t>(result.sections.size())},
                     {"filter", form::filterName(bandOf(result.parameters.form), language)}};
    const bool unmeasured = std::any_of(result.sections.begin(), result.sections.end(),
                                        [](const TrajectorySection& each) { return !each.form_measured; });
    answer.sentence = unmeasured ? LT_TEXT("Engine", "Form not measured: the noise hides it · {filter}")
                      : result.sections.size() > 1
                          ? LT_TEXT("Engine", "Section {section} of {count} is the worst · {filter}")
                          : LT_TEXT("Engine", "{filter}");
    if (!result.longitudinal) return answer;
    const double taper_um = result.longitudinal->taper_diameter_um;
    const double barrel_um = result.longitudinal->barrel_um;
    answer.findings.push_back({LT_TEXT("Engine", "Taper {taper_um:+1} µm on diameter, over the measured length"),
                               {{"taper_um", taper_um}},
                               {},
                               {}});
    answer.findings.push_back({barrel_um < 0 ? LT_TEXT("Engine", "Saddle {size_um:1} µm on radius")
                                             : LT_TEXT("Engine", "Barrel {size_um:1} µm on radius"),
                               {{"size_um", std::abs(barrel_um)}},
                               {},
                               {}});
    return answer;
}

report::Section trajectorySummary(const TrajectoryResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language)}};
    if (result.longitudinal) section.blocks.push_back(longitudinalTable(*result.longitudinal));
    if (const auto worst = result.worstSection()) {
        section.blocks.push_back(worstTable(result.sections[*worst], result));
        section.blocks.push_back(errorMotionTable(result.sections[*worst]));
    }
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Section trajectoryMethod(const TrajectoryResult& result, const Language& language)
{
    report::Section method{LT_TEXT("Engine", "Method and parameters"), {}};
    if (!result.cutting.empty()) method.blocks.push_back(cuttingTable(result, language));
    method.blocks.push_back(report::Paragraph{
        LT_TEXT(
            "Engine",
            "The image of the surface is the path of the tool as seen from the axis of the workpiece: radius |AP| with "
            "A = (X3, Y3), P = (D/2 + Xp, Yp), at the angle of the spindle plus atan2(Y3 - Yp, D/2 - X3 + Xp). "
            "Diameters are referenced to the nominal one. Roundness by ISO 12181 about the fitted centre."),
        {}});
    method.blocks.push_back(report::parametersTable(result.parameters, language, result.used));
    return method;
}

report::Table sectionsTable(const TrajectoryResult& result)
{
    report::Table table =
        report::listTable<TrajectorySection>(LT_TEXT("Engine", "All sections against the tolerance"), result.sections,
                                             {"section", "z_mm", "RONt_um", "judged", "diameter_mm", "centre_x_um",
                                              "centre_y_um", "run_out_um", "two_point.range_um", "revolutions_used"});
    table.columns[2] =
        report::Labelled{{}, micrometre, "RONt(" + std::string(name(result.parameters.form.circle)) + ")"};
    return table;
}

report::Document trajectoryReport(const TrajectoryResult& result, const std::vector<InputFile>& inputs,
                                  const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Trajectories and the machined surface");
    document.verification = {&form::formVerification()};
    document.inputs = inputs;
    document.synthetic = contains(result.notes, notes::syntheticData);
    document.sections.push_back(trajectorySummary(result, language));
    if (const auto worst = result.worstSection()) {
        const TrajectorySection& section = result.sections[*worst];
        document.sections.push_back(alongSection(result, language));
        document.sections.push_back(
            {LT_TEXT("Engine", "Image of the surface in the section with the largest deviation"),
             {roundnessPolarPlot(section.roundness, language), spectrumPlot(section.roundness, language),
              harmonicsTable(section.roundness), methodTable(section.roundness, language)}});
        document.sections.push_back(motionSection(section, result.workpiece_diameter_mm, language));
    }
    document.sections.push_back(trajectoryMethod(result, language));
    return document;
}

}  // namespace lathelier::trajectory
