#include "engine/trajectory/trajectory_report.h"

#include <algorithm>
#include <cmath>

#include "engine/form/form_verification.h"
#include "engine/form/roundness_report.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/trajectory/channel_map.h"
#include "engine/trajectory/trajectory_plots.h"
#include "engine/trajectory/trajectory_quantities.h"

namespace lathelier::trajectory {
namespace {

QuantityTable longitudinalTable(const LongitudinalSection& section)
{
    return quantityTable(LT_TEXT("Engine", "Longitudinal section"), section,
                         {"taper_diameter_um", "barrel_um", "diameter_range_um", "half_diameter_range_um",
                          "axis_straightness_um", "profile_straightness_um", "CYLt_LSCY_um", "CYLt_MZCY_um"});
}

QuantityTable worstTable(const TrajectorySection& section, const TrajectoryResult& result)
{
    QuantityTable table =
        quantityTable(LT_TEXT("Engine", "The section with the largest deviation"), section,
                      {"section", "z_mm", "RONt_MZCI_um", "RONt_LSCI_um", "RONt_MICI_um", "RONt_MCCI_um",
                       "RONt_expanded_uncertainty_um", "run_out_um", "two_point.range_um", "two_point.half_range_um"});
    if (result.parameters.form.tolerance_um)
        for (Quantity& row : quantityRows(section, {"tolerance_um"})) table.rows.push_back(std::move(row));
    if (result.verdict) table.rows.push_back({LT_TEXT("Engine", "Verdict"), name(*result.verdict), {}});
    return table;
}

/// For narrow columns: short headings.
Table sectionsTable(const TrajectoryResult& result)
{
    Table table =
        listTable<TrajectorySection>(LT_TEXT("Engine", "All sections"), result.sections,
                                     {"section", "z_mm", "diameter_mm", "RONt_MZCI_um", "RONt_LSCI_um", "RONt_MICI_um",
                                      "RONt_MCCI_um", "two_point.range_um", "run_out_um", "revolutions_used"});
    table.columns = {LT_TEXT("Engine", "section"),
                     LT_TEXT("Engine", "z (mm)"),
                     LT_TEXT("Engine", "diameter (mm)"),
                     "MZCI (µm)",
                     "LSCI (µm)",
                     "MICI (µm)",
                     "MCCI (µm)",
                     LT_TEXT("Engine", "two-point (µm)"),
                     LT_TEXT("Engine", "run-out (µm)"),
                     LT_TEXT("Engine", "revolutions")};
    if (!result.parameters.form.tolerance_um) return table;
    table.columns.emplace_back(LT_TEXT("Engine", "verdict"));
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto verdict = result.sections[i].roundness.verdict;
        table.rows[i].push_back(verdict ? Value(shortName(*verdict)) : Value());
    }
    return table;
}

Table errorMotionTable(const TrajectorySection& section)
{
    std::vector<ErrorMotion> motions(section.error_motion.begin(), section.error_motion.end());
    if (section.rotating) motions.push_back(*section.rotating);
    Table table = listTable<ErrorMotion>(LT_TEXT("Engine", "Error motion (ISO 230-7), without mean and eccentricity"),
                                         motions, {"synchronous_um", "asynchronous_um", "total_um"});
    table.columns = {LT_TEXT("Engine", "signal"), LT_TEXT("Engine", "synchronous (µm)"),
                     LT_TEXT("Engine", "asynchronous (µm)"), LT_TEXT("Engine", "total (µm)"),
                     LT_TEXT("Engine", "drift (µm/rev)")};
    table.decimals = {0, 2, 2, 2, 4};
    for (std::size_t probe = 0; probe < table.rows.size(); ++probe) {
        std::vector<Value>& row = table.rows[probe];
        const bool single = probe < section.error_motion.size();
        const bool known = single && !section.revolutions_um[probe].empty();  // averages tell of no drift
        row.insert(row.begin(), single ? Value(std::string(name(static_cast<Probe>(probe))))
                                       : Value(LT_TEXT("Engine", "rotating direction")));
        row.push_back(known ? Value(section.drift_um_per_rev[probe]) : Value());
    }
    return table;
}

QuantityTable cuttingTable(const TrajectoryResult& result, const Language& language)
{
    QuantityTable table{LT_TEXT("Engine", "Cutting data, as the record states them"), {}};
    for (const auto& [key, value] : result.cutting) table.rows.push_back({key, text(value, language), {}});
    return table;
}

Section alongSection(const TrajectoryResult& result, const Language& language)
{
    Section section{LT_TEXT("Engine", "Along the workpiece"), {}};
    if (result.longitudinal) section.blocks.push_back(longitudinalPlot(*result.longitudinal, language));
    if (result.sections.size() > 1) section.blocks.push_back(roundnessAlongAxis(result));
    section.blocks.push_back(sectionsTable(result));
    return section;
}

Section motionSection(const TrajectorySection& worst, double workpiece_diameter_mm, const Language& language)
{
    Section section{LT_TEXT("Engine", "Motion of spindle and tool in that section"),
                    {trajectoryPlot(worst, language), envelopePlot(worst),
                     errorMotionPlot(worst, workpiece_diameter_mm, Probe::X3, language), errorMotionTable(worst)}};
    if (!worst.revolution_RONt_um.empty()) {
        double least = HUGE_VAL, most = 0;
        for (const double value : worst.revolution_RONt_um) {
            least = std::fmin(least, value);
            most = std::fmax(most, value);
        }
        section.blocks.push_back(
            Paragraph{LT_TEXT("Engine",
                              "The images of single revolutions have RONt(LSCI) from {least} to {most} µm; their mean "
                              "hides what differs from turn to turn."),
                      {{"least", fixed(least, 2, language)}, {"most", fixed(most, 2, language)}}});
    }
    return section;
}

}  // namespace

Headline headline(const TrajectoryResult& result, const Language& language)
{
    Headline answer;
    const auto worst = result.worstSection();
    if (!worst) return answer;
    const TrajectorySection& section = result.sections[*worst];
    std::string& line = answer.text;
    line = "RONt(" + std::string(name(result.parameters.form.circle)) + ") " +
           fixed(headlineDeviation_um(section.roundness), 1, language) + " µm";
    const auto add = [&](Text pattern, const Values& values) {
        line += fill(text(pattern, language), values, language);
    };
    if (result.sections.size() > 1)
        add(LT_TEXT("Engine", " (section {section} of {count})"),
            {{"section", std::int64_t{section.section}}, {"count", static_cast<std::int64_t>(result.sections.size())}});
    line += " · " + form::filterName(bandOf(result.parameters.form), language);
    if (result.longitudinal) {
        const double taper_um = result.longitudinal->taper_diameter_um;
        const double barrel_um = result.longitudinal->barrel_um;
        const std::string plus = taper_um > 0 ? "+" : "";
        add(LT_TEXT("Engine", " · taper {taper} µm on diameter"), {{"taper", plus + fixed(taper_um, 1, language)}});
        add(barrel_um < 0 ? LT_TEXT("Engine", " · saddle {size} µm") : LT_TEXT("Engine", " · barrel {size} µm"),
            {{"size", fixed(std::abs(barrel_um), 1, language)}});
    }
    const bool unmeasured = std::any_of(result.sections.begin(), result.sections.end(),
                                        [](const TrajectorySection& each) { return !each.form_measured; });
    if (unmeasured) add(LT_TEXT("Engine", " · form not measured"), {});
    if (result.verdict) {
        const Values values{{"tolerance", *result.parameters.form.tolerance_um}};
        switch (*result.verdict) {
            case Verdict::Pass: add(LT_TEXT("Engine", " · within {tolerance} µm"), values); break;
            case Verdict::Fail: add(LT_TEXT("Engine", " · above {tolerance} µm"), values); break;
            case Verdict::Undecided:
                if (!unmeasured) add(LT_TEXT("Engine", " · not decided: too near to {tolerance} µm"), values);
                break;
        }
        answer.verdict = passed(result.verdict);
    }
    line = keptTogether(line);
    return answer;
}

Section trajectorySummary(const TrajectoryResult& result, const Language& language)
{
    Section section{LT_TEXT("Engine", "Result"), {headline(result, language)}};
    if (result.longitudinal) section.blocks.push_back(longitudinalTable(*result.longitudinal));
    if (const auto worst = result.worstSection()) {
        section.blocks.push_back(worstTable(result.sections[*worst], result));
        section.blocks.push_back(errorMotionTable(result.sections[*worst]));
    }
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

Section trajectoryMethod(const TrajectoryResult& result, const Language& language)
{
    Section method{LT_TEXT("Engine", "Method and parameters"), {}};
    if (!result.cutting.empty()) method.blocks.push_back(cuttingTable(result, language));
    method.blocks.push_back(Paragraph{
        LT_TEXT(
            "Engine",
            "The image of the surface is the path of the tool as seen from the axis of the workpiece: radius |AP| with "
            "A = (X3, Y3), P = (D/2 + Xp, Yp), at the angle of the spindle plus atan2(Y3 - Yp, D/2 - X3 + Xp). "
            "Diameters are referenced to the nominal one. Roundness by ISO 12181 about the fitted centre."),
        {}});
    method.blocks.push_back(parametersTable(result.parameters, language));
    return method;
}

Document trajectoryReport(const TrajectoryResult& result, const std::vector<InputFile>& inputs,
                          const Language& language)
{
    Document document;
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
