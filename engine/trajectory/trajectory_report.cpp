#include "engine/trajectory/trajectory_report.h"

#include <algorithm>
#include <cmath>

#include "engine/form/roundness_report.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/trajectory/channel_map.h"
#include "engine/trajectory/trajectory_plots.h"

namespace lathelier::trajectory {
namespace {

const Text um = LT_TEXT("Engine", "µm");
const Text mm = LT_TEXT("Engine", "mm");

QuantityTable longitudinalTable(const LongitudinalSection& section)
{
    return {LT_TEXT("Engine", "Longitudinal section"),
            {{LT_TEXT("Engine", "Taper on diameter (+ grows from the free end)"), section.taper_diameter_um, um, 2},
             {LT_TEXT("Engine", "Barrel on radius (+ barrel, - saddle)"), section.barrel_um, um, 2},
             {LT_TEXT("Engine", "Range of the diameters"), section.diameter_range_um, um, 2},
             {LT_TEXT("Engine", "Half of it, as GOST 24642-81 has it"), section.half_diameter_range_um, um, 2},
             {LT_TEXT("Engine", "Straightness of the axis"), section.axis_straightness_um, um, 2},
             {LT_TEXT("Engine", "Straightness of the profile (residual about its line)"),
              section.profile_straightness_um, um, 2},
             {LT_TEXT("Engine", "Cylindricity CYLt(LSCY)"), section.CYLt_LSCY_um, um, 2},
             {LT_TEXT("Engine", "Cylindricity CYLt(MZCY), locally optimal"), section.CYLt_MZCY_um, um, 2}}};
}

QuantityTable worstTable(const TrajectorySection& section, const TrajectoryResult& result)
{
    const form::ReferenceCircles& c = section.roundness.circles;
    QuantityTable table{
        LT_TEXT("Engine", "The section with the largest deviation"),
        {{LT_TEXT("Engine", "Section"), std::int64_t{section.section}, {}},
         {LT_TEXT("Engine", "From the free end"), section.z_mm, mm},
         {"RONt(MZCI)", c.MZCI.RONt_um, um, 2},
         {"RONt(LSCI)", c.LSCI.RONt_um, um, 2},
         {"RONt(MICI)", c.MICI.RONt_um, um, 2},
         {"RONt(MCCI)", c.MCCI.RONt_um, um, 2},
         {LT_TEXT("Engine", "Expanded uncertainty (95 %)"), section.roundness.RONt_expanded_uncertainty_um, um, 2},
         {LT_TEXT("Engine", "Radial run-out about the spindle axis (the paper's; not roundness)"), section.run_out_um,
          um, 2},
         {LT_TEXT("Engine", "Two-point size range"), section.roundness.two_point.range_um, um, 2},
         {LT_TEXT("Engine", "Half of it, as GOST 24642-81 has it"), section.roundness.two_point.half_range_um, um, 2}}};
    std::erase_if(table.rows, [](const Quantity& row) { return std::holds_alternative<std::monostate>(row.value); });
    if (result.parameters.form.tolerance_um)
        table.rows.push_back({LT_TEXT("Engine", "Tolerance"), *result.parameters.form.tolerance_um, um});
    if (result.verdict) table.rows.push_back({LT_TEXT("Engine", "Verdict"), verdictName(*result.verdict), {}});
    return table;
}

/// For narrow columns.
Text shortVerdict(form::FormVerdict verdict)
{
    switch (verdict) {
        case form::FormVerdict::Pass: return LT_TEXT("Engine", "✓ within");
        case form::FormVerdict::Fail: return LT_TEXT("Engine", "✗ above");
        case form::FormVerdict::Undecided: return LT_TEXT("Engine", "? undecided");
    }
    return {};
}

Table sectionsTable(const TrajectoryResult& result)
{
    Table table{LT_TEXT("Engine", "All sections"),
                {LT_TEXT("Engine", "section"), LT_TEXT("Engine", "z (mm)"), LT_TEXT("Engine", "diameter (mm)"),
                 "MZCI (µm)", "LSCI (µm)", "MICI (µm)", "MCCI (µm)", LT_TEXT("Engine", "two-point (µm)"),
                 LT_TEXT("Engine", "run-out (µm)"), LT_TEXT("Engine", "revolutions")},
                {},
                {0, 2, 5, 2, 2, 2, 2, 2, 2, 0}};
    const bool judged = result.parameters.form.tolerance_um.has_value();
    if (judged) table.columns.push_back(LT_TEXT("Engine", "verdict"));
    for (const TrajectorySection& s : result.sections) {
        const form::ReferenceCircles& c = s.roundness.circles;
        std::vector<Value> row{std::int64_t{s.section},
                               s.z_mm,
                               2 * c.LSCI.radius_mm,
                               c.MZCI.RONt_um,
                               c.LSCI.RONt_um,
                               c.MICI.RONt_um,
                               c.MCCI.RONt_um,
                               s.roundness.two_point.range_um,
                               s.run_out_um,
                               std::int64_t{s.revolutions_used}};
        if (judged) {
            Value verdict;
            if (s.roundness.verdict) verdict = shortVerdict(*s.roundness.verdict);
            row.push_back(std::move(verdict));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table errorMotionTable(const TrajectorySection& section)
{
    Table table{
        LT_TEXT("Engine", "Error motion (ISO 230-7), without mean and eccentricity"),
        {LT_TEXT("Engine", "signal"), LT_TEXT("Engine", "synchronous (µm)"), LT_TEXT("Engine", "asynchronous (µm)"),
         LT_TEXT("Engine", "total (µm)"), LT_TEXT("Engine", "drift (µm/rev)")},
        {},
        {0, 2, 2, 2, 4}};
    for (std::size_t probe = 0; probe < section.error_motion.size(); ++probe) {
        const ErrorMotion& motion = section.error_motion[probe];
        const bool known = !section.revolutions_um[probe].empty();  // averages tell of no drift
        table.rows.push_back({std::string(name(static_cast<Probe>(probe))), motion.synchronous_um,
                              motion.asynchronous_um, motion.total_um,
                              known ? section.drift_um_per_rev[probe] : HUGE_VAL});
    }
    if (section.rotating)
        table.rows.push_back({LT_TEXT("Engine", "rotating direction"), section.rotating->synchronous_um,
                              section.rotating->asynchronous_um, section.rotating->total_um, Value()});
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
            case form::FormVerdict::Pass: add(LT_TEXT("Engine", " · within {tolerance} µm"), values); break;
            case form::FormVerdict::Fail: add(LT_TEXT("Engine", " · above {tolerance} µm"), values); break;
            case form::FormVerdict::Undecided:
                if (!unmeasured) add(LT_TEXT("Engine", " · not decided: too near to {tolerance} µm"), values);
                break;
        }
        if (*result.verdict != form::FormVerdict::Undecided)
            answer.verdict = *result.verdict == form::FormVerdict::Pass;
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
