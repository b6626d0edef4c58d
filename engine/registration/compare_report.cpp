#include "engine/registration/compare_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"
#include "engine/io/io_codes.h"
#include "engine/registration/compare_plots.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/registration_verification.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::registration {
namespace {

Text methodName(CompareMethod method)
{
    switch (method) {
        case CompareMethod::Auto: break;
        case CompareMethod::Revolution: return LT_TEXT("Engine", "body of revolution");
        case CompareMethod::Plane: return LT_TEXT("Engine", "point to plane");
        case CompareMethod::Point: return LT_TEXT("Engine", "point to point");
    }
    return LT_TEXT("Engine", "automatic");
}

/// Distances without a sign have a size only.
report::QuantityTable statisticsTable(const CompareResult& result)
{
    const Text title = LT_TEXT("Engine", "Deviation of the copy from the original's surface");
    if (!result.has_sign) return report::quantityTable(title, result.statistics, {"rmse_mm", "p95_abs_mm"});
    return report::quantityTable(title, result.statistics,
                                 {"rmse_mm", "mean_mm", "std_mm", "mad_sigma_mm", "median_mm", "min_mm", "max_mm",
                                  "p2_5_mm", "p97_5_mm", "p95_abs_mm"});
}

report::QuantityTable verdictTable(const CompareResult& result)
{
    const CompareParameters& asked = result.parameters;
    report::QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    const auto add = [&table](const auto& of, std::initializer_list<const char*> keys) {
        for (report::Quantity& row : report::quantityRows(of, keys)) table.rows.push_back(std::move(row));
    };
    if (result.verdict) {
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), name(*result.verdict), {}});
        if (asked.tolerance_mm) add(result, {"tolerance_mm"});
        table.rows.push_back({LT_TEXT("Engine", "Verdict by"), name(asked.verdict_rule), {}});
        if (asked.verdict_rule == VerdictRule::Surface)
            table.rows.push_back({LT_TEXT("Engine", "Decision rule"), name(asked.decision), {}});
    } else {
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), LT_TEXT("Engine", "none: no tolerance was given"), {}});
    }
    if (const auto& worst = result.worst) {
        add(*worst, {"deviation_mm", "uncertainty_mm"});
        if (worst->z_mm) add(*worst, {"z_mm"});
        if (worst->angle_deg) add(*worst, {"angle_deg"});
        add(*worst, {"cell_mm"});
    }
    if (std::isfinite(result.scatter_mm)) add(result, {"scatter_mm"});
    if (result.verdict && result.within_tolerance_percent) {
        add(result, {"within_tolerance_percent"});
        if (asked.verdict_rule == VerdictRule::Points) add(result, {"pass_percent"});
    }
    if (asked.scanner_accuracy_mm) add(result, {"scanner_accuracy_mm", "distinguishable_from_scanner"});
    add(result.statistics, {"overlap_percent", "points_used", "points_excluded"});
    return table;
}

report::Table findingsTable(const CompareResult& result)
{
    return report::listTable<Finding>(
        LT_TEXT("Engine", "What differs"), result.findings,
        {"difference", "z_start_mm", "z_end_mm", "value_mm", "uncertainty_mm", "limit_mm", "judged"});
}

report::QuantityTable alignmentTable(const CompareResult& result)
{
    report::QuantityTable table{LT_TEXT("Engine", "Alignment"),
                                {{LT_TEXT("Engine", "Method"), methodName(result.method_used), {}}}};
    for (report::Quantity& row : report::quantityRows(result.alignment, {"converged", "iterations"}))
        table.rows.push_back(std::move(row));
    std::vector<report::Quantity> uncertainty =
        report::quantityRows(result.alignment.uncertainty, {"axial_um", "radial_um", "axis_deg"});
    if (!result.alignment.reference_axis) {
        uncertainty[0].name = LT_TEXT("Engine", "Uncertainty, largest direction (k = 2)");
        uncertainty[1].name = LT_TEXT("Engine", "Uncertainty across it (k = 2)");
        uncertainty[2].name = LT_TEXT("Engine", "Uncertainty of the rotation (k = 2)");
    }
    table.rows.insert(table.rows.end(), uncertainty.begin(), uncertainty.end());
    return table;
}

report::QuantityTable paperTable(const CompareResult& result)
{
    return report::quantityTable(LT_TEXT("Engine", "Nearest-point figure, as in the source paper"), result,
                                 {"cloud_to_cloud_rmse_mm", "sampling_floor_mm"});
}

report::Table freeMotionsTable(const CompareResult& result)
{
    return report::listTable<FreeMotion>(
        LT_TEXT("Engine", "Motions the geometry does not determine"), result.alignment.free_motions,
        {"motion", "direction_x", "direction_y", "direction_z", "point_x_mm", "point_y_mm", "point_z_mm"});
}

report::Table transformTable(const CompareResult& result)
{
    report::Table table{LT_TEXT("Engine", "From the copy's coordinates to the original's"),
                        {LT_TEXT("Engine", "x"), LT_TEXT("Engine", "y"), LT_TEXT("Engine", "z"),
                         report::Labelled{LT_TEXT("Engine", "shift"), unit::mm}},
                        {},
                        {9, 9, 9, 6}};
    const Eigen::Matrix4d matrix = result.alignment.reference_T_copy.matrix();
    for (int row = 0; row < 3; ++row)
        table.rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    return table;
}

}  // namespace

report::Table zonesTable(const CompareResult& result)
{
    std::vector<const char*> keys{"z_start_mm", "z_end_mm", "mean_mm", "uncertainty_mm", "std_mm", "points"};
    if (!result.parameters.zones.empty()) {
        keys.insert(keys.begin(), "name");
        keys.insert(keys.end(), {"lower_mm", "upper_mm"});
    }
    if (result.verdict) keys.push_back("judged");
    return report::listTable<Zone>(LT_TEXT("Engine", "Zones along the axis"), result.zones, keys);
}

namespace {

report::Section whereSection(const CompareResult& result, const Language& language,
                             std::vector<report::Picture> pictures)
{
    report::Section section{LT_TEXT("Engine", "Deviation map"), {}};
    section.blocks.push_back(
        result.has_sign
            ? report::Paragraph{LT_TEXT("Engine",
                                        "Deviations are measured along the normal of the original's surface; "
                                        "plus means material in excess."),
                                {}}
            : report::Paragraph{
                  LT_TEXT("Engine", "Deviations are distances from the original's surface, without a sign."), {}});
    for (report::Picture& picture : pictures) section.blocks.push_back(std::move(picture));
    if (result.unrolled && result.parameters.tolerance_mm) section.blocks.push_back(unrolledMap(result, true));
    if (result.unrolled) section.blocks.push_back(unrolledMap(result, false));
    if (result.meridian) section.blocks.push_back(magnifiedMeridian(result, language));
    section.blocks.push_back(histogramPlot(result, language));
    if (!result.zones.empty()) section.blocks.push_back(zonesTable(result));
    return section;
}

report::Section certaintySection(const CompareResult& result)
{
    report::Section section{LT_TEXT("Engine", "Measurement uncertainty"), {alignmentTable(result), paperTable(result)}};
    section.blocks.push_back(report::Paragraph{
        LT_TEXT("Engine",
                "The cloud-to-cloud figure mixes the difference of the parts with the distance between neighbouring "
                "points: even identical parts reach its floor. The deviation from the surface does not depend on it."),
        {}});
    if (!result.alignment.free_motions.empty()) section.blocks.push_back(freeMotionsTable(result));
    return section;
}

}  // namespace

namespace {

Text patternOf(const Finding& finding)
{
    switch (finding.kind) {
        case Finding::Kind::Step:
            if (finding.z_start_mm == finding.z_end_mm)
                return LT_TEXT("Engine", "Face {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1} mm");
            return LT_TEXT("Engine", "Step {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm");
        case Finding::Kind::Taper:
            return LT_TEXT("Engine", "Taper {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm");
        case Finding::Kind::Barrel:
            return finding.value_mm < 0
                       ? LT_TEXT("Engine", "Saddle {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm")
                       : LT_TEXT("Engine", "Barrel {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm");
        case Finding::Kind::Bump:
            return finding.z_start_mm
                       ? LT_TEXT("Engine", "Bump {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm")
                       : LT_TEXT("Engine",
                                 "Bump {value_mm:+3} ± {uncertainty_mm:3} mm at X {x_mm:1} Y {y_mm:1} Z {z_mm:1}");
        case Finding::Kind::Missing: return LT_TEXT("Engine", "No data of the copy · z {from_mm:1}-{to_mm:1} mm");
    }
    return {};
}

report::Finding findingOf(const Finding& finding)
{
    report::Finding said;
    said.pattern = patternOf(finding);
    said.values = {{"value_mm", finding.value_mm},
                   {"uncertainty_mm", finding.uncertainty_mm},
                   {"x_mm", finding.point_mm.x()},
                   {"y_mm", finding.point_mm.y()},
                   {"z_mm", finding.point_mm.z()}};
    if (finding.z_start_mm && finding.z_end_mm) {
        said.values.emplace_back("from_mm", *finding.z_start_mm);
        said.values.emplace_back("to_mm", *finding.z_end_mm);
        said.place.z_mm = Interval{*finding.z_start_mm, *finding.z_end_mm};
    }
    said.verdict = finding.verdict;
    return said;
}

/// The limits where the worst place lies.
void addLimits(const CompareResult& result, report::Answer& answer)
{
    if (result.parameters.tolerance_mm) {
        answer.lower_limit = -*result.parameters.tolerance_mm;
        answer.upper_limit = *result.parameters.tolerance_mm;
    }
    if (!result.worst->z_mm) return;
    for (const ZoneLimits& zone : result.parameters.zones)
        if (*result.worst->z_mm >= zone.z_start_mm && *result.worst->z_mm <= zone.z_end_mm) {
            answer.lower_limit = zone.lower_mm;
            answer.upper_limit = zone.upper_mm;
            if (!zone.name.empty()) answer.subject += ", " + zone.name;
        }
}

/// The verdict of a value by the rule of the comparison.
Verdict verdictOf(const CompareResult& result, const report::Answer& answer)
{
    const double lower = answer.lower_limit.value_or(-std::numeric_limits<double>::infinity());
    const double upper = answer.upper_limit.value_or(std::numeric_limits<double>::infinity());
    return judge(std::max(*answer.value - upper, lower - *answer.value), answer.expanded_uncertainty.value_or(0), 0,
                 result.parameters.decision);
}

/// A difference in form that decides the verdict, where the worst place does not, takes its place in the headline:
/// value, uncertainty and limit are those that the rule was applied to.
void showWhatDecides(const CompareResult& result, report::Answer& answer, const Language& language)
{
    if (!result.verdict || *result.verdict == Verdict::Pass || verdictOf(result, answer) == *result.verdict) return;
    const auto deciding = std::find_if(result.findings.begin(), result.findings.end(), [&](const Finding& finding) {
        return finding.verdict == result.verdict && finding.limit_mm;
    });
    if (deciding == result.findings.end()) return;
    answer.quantity = name(deciding->kind);
    answer.value = deciding->value_mm;
    answer.expanded_uncertainty = deciding->uncertainty_mm;
    (deciding->value_mm < 0 ? answer.lower_limit : answer.upper_limit) =
        deciding->value_mm < 0 ? -*deciding->limit_mm : *deciding->limit_mm;
    answer.subject.clear();
    if (deciding->z_start_mm)
        answer.subject = fill(text(LT_TEXT("Engine", "z\u00A0{from_mm:1}-{to_mm:1}\u00A0mm"), language),
                              {{"from_mm", *deciding->z_start_mm}, {"to_mm", *deciding->z_end_mm}}, language);
}

}  // namespace

report::Answer answer(const CompareResult& result, const Language& language)
{
    const DeviationStatistics& s = result.statistics;
    const bool by_surface = result.worst && result.parameters.verdict_rule == VerdictRule::Surface;
    report::Answer answer;
    answer.unit = unit::mm;
    answer.verdict = result.verdict;
    if (by_surface) {
        const WorstPlace& worst = *result.worst;
        answer.quantity = LT_TEXT("Engine", "Worst local deviation");
        answer.value = worst.deviation_mm;
        answer.expanded_uncertainty = worst.uncertainty_mm;
        answer.is_signed = result.has_sign;
        answer.decimals = 3;
        if (worst.z_mm)
            answer.subject =
                fill(text(LT_TEXT("Engine", "z\u00A0{z_mm:1}\u00A0mm"), language), {{"z_mm", *worst.z_mm}}, language);
        if (worst.z_mm && worst.angle_deg) answer.subject += ", " + fixed(*worst.angle_deg, 0, language) + "°";
        addLimits(result, answer);
        showWhatDecides(result, answer, language);
    } else {
        answer.quantity = LT_TEXT("Engine", "RMS deviation");
        answer.value = s.rmse_mm;
        answer.decimals = 4;
    }
    answer.values = {{"mean_mm", s.mean_mm},
                     {"rms_mm", s.rmse_mm},
                     {"scatter_mm", result.scatter_mm},
                     {"method", methodName(result.method_used)}};
    if (!result.has_sign)
        answer.sentence = LT_TEXT("Engine", "{method}");
    else if (by_surface)
        answer.sentence = LT_TEXT(
            "Engine", "RMS {rms_mm:4} mm · mean {mean_mm:+4} mm · noise of the scans {scatter_mm:4} mm · {method}");
    else if (result.within_tolerance_percent && result.parameters.tolerance_mm) {
        answer.sentence =
            LT_TEXT("Engine", "mean {mean_mm:+4} mm · {method} · {share} % of the points within ±{tolerance_mm} mm");
        answer.values.emplace_back("share", fixed(*result.within_tolerance_percent, 1, language));
        answer.values.emplace_back("tolerance_mm", *result.parameters.tolerance_mm);
    } else
        answer.sentence = LT_TEXT("Engine", "mean {mean_mm:+4} mm · {method}");
    for (const Finding& finding : result.findings)
        if (answer.findings.size() < 3) answer.findings.push_back(findingOf(finding));
    return answer;
}

report::Section compareSummary(const CompareResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language)}};
    if (!result.findings.empty()) section.blocks.push_back(findingsTable(result));
    section.blocks.push_back(verdictTable(result));  // printed beside the next one
    section.blocks.push_back(statisticsTable(result));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document compareReport(const CompareResult& result, const std::vector<InputFile>& inputs,
                               const Language& language, std::vector<report::Picture> pictures)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Comparison of a copy with its original");
    document.verification = {&registrationVerification()};
    document.inputs = inputs;
    document.synthetic = contains(result.notes, notes::syntheticData);
    report::Section summary = compareSummary(result, language);
    // The picture under the answer.
    if (!pictures.empty()) {
        pictures.front().width = report::Picture::Width::Page;
        summary.blocks.insert(summary.blocks.begin() + 1, std::move(pictures.front()));
        pictures.erase(pictures.begin());
    } else if (result.meridian) {
        summary.blocks.insert(summary.blocks.begin() + 1, deviationAlongAxis(result, language));
    }
    document.sections = {std::move(summary),
                         whereSection(result, language, std::move(pictures)),
                         certaintySection(result),
                         {LT_TEXT("Engine", "Method and parameters"),
                          {report::parametersTable(result.parameters, language), transformTable(result)}}};
    return document;
}

}  // namespace lathelier::registration
