#include "engine/registration/compare_report.h"

#include <cmath>

#include "engine/io/io_codes.h"
#include "engine/registration/compare_plots.h"
#include "engine/registration/registration_verification.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"

namespace lathelier::registration {
namespace {

const Text mm = LT_TEXT("Engine", "mm");
const Text um = LT_TEXT("Engine", "µm");
const Text percent = LT_TEXT("Engine", "%");

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

/// A number of which a sign is expected; not given where the deviations have none.
Value signedValue(double value, bool has_sign)
{
    return has_sign ? Value(value) : Value();
}

Value given(const std::optional<double>& value)
{
    return value ? Value(*value) : Value();
}

report::QuantityTable statisticsTable(const CompareResult& result)
{
    const DeviationStatistics& s = result.statistics;
    const bool sign = result.has_sign;
    report::QuantityTable table{
        LT_TEXT("Engine", "Deviation of the copy from the original's surface"),
        {{LT_TEXT("Engine", "Root mean square"), s.rmse_mm, mm, 4},
         {LT_TEXT("Engine", "Mean"), signedValue(s.mean_mm, sign), mm, 4},
         {LT_TEXT("Engine", "Standard deviation"), signedValue(s.std_mm, sign), mm, 4},
         {LT_TEXT("Engine", "Robust standard deviation (MAD)"), signedValue(s.mad_sigma_mm, sign), mm, 4},
         {LT_TEXT("Engine", "Median"), signedValue(s.median_mm, sign), mm, 4},
         {LT_TEXT("Engine", "Smallest"), signedValue(s.min_mm, sign), mm, 4},
         {LT_TEXT("Engine", "Largest"), signedValue(s.max_mm, sign), mm, 4},
         {LT_TEXT("Engine", "95 % of the points lie between"), signedValue(s.p2_5_mm, sign), mm, 4},
         {LT_TEXT("Engine", "… and"), signedValue(s.p97_5_mm, sign), mm, 4},
         {LT_TEXT("Engine", "95 % of the sizes lie below"), s.p95_abs_mm, mm, 4}}};
    std::erase_if(table.rows,
                  [](const report::Quantity& row) { return std::holds_alternative<std::monostate>(row.value); });
    return table;
}

/// Local means are compared with the limit and their allowance, by either rule.
Text decisionText(DecisionRule rule)
{
    return rule == DecisionRule::Simple
               ? LT_TEXT("Engine", "simple: out only where a local mean surely exceeds the limit")
               : name(rule);
}

report::QuantityTable verdictTable(const CompareResult& result)
{
    const DeviationStatistics& s = result.statistics;
    const CompareParameters& asked = result.parameters;
    report::QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    if (result.verdict) {
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), name(*result.verdict), {}});
        if (asked.tolerance_mm)
            table.rows.push_back({LT_TEXT("Engine", "Tolerance, plus and minus"), given(asked.tolerance_mm), mm});
        table.rows.push_back({LT_TEXT("Engine", "Verdict by"), name(asked.verdict_rule), {}});
        if (asked.verdict_rule == VerdictRule::Surface)
            table.rows.push_back({LT_TEXT("Engine", "Decision rule"), decisionText(asked.decision), {}});
    } else {
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), LT_TEXT("Engine", "none: no tolerance was given"), {}});
    }
    if (const auto& worst = result.worst) {
        table.rows.push_back({LT_TEXT("Engine", "Worst place: mean deviation"), worst->deviation_mm, mm, 4});
        table.rows.push_back({LT_TEXT("Engine", "… its uncertainty (k = 2)"), worst->uncertainty_mm, mm, 4});
        if (worst->z_mm) table.rows.push_back({LT_TEXT("Engine", "… along the axis at"), *worst->z_mm, mm, 2});
        if (worst->angle_deg)
            table.rows.push_back({LT_TEXT("Engine", "… at the angle"), *worst->angle_deg, LT_TEXT("Engine", "°"), 1});
        table.rows.push_back({LT_TEXT("Engine", "… mean over a square of"), worst->cell_mm, mm, 2});
    }
    if (std::isfinite(result.scatter_mm))
        table.rows.push_back({LT_TEXT("Engine", "Noise of the points about the surface"), result.scatter_mm, mm, 4});
    if (result.verdict && result.within_tolerance_percent) {
        table.rows.push_back(
            {LT_TEXT("Engine", "Share within tolerance"), given(result.within_tolerance_percent), percent, 2});
        if (asked.verdict_rule == VerdictRule::Points)
            table.rows.push_back({LT_TEXT("Engine", "Share needed to pass"), asked.pass_percent, percent, 2});
    }
    if (asked.scanner_accuracy_mm) {
        table.rows.push_back({LT_TEXT("Engine", "Scanner's accuracy"), given(asked.scanner_accuracy_mm), mm});
        table.rows.push_back(
            {LT_TEXT("Engine", "Difference told from the scanner's accuracy"),
             result.distinguishable_from_scanner ? Value(*result.distinguishable_from_scanner) : Value(),
             {}});
    }
    table.rows.push_back(
        {LT_TEXT("Engine", "Overlap (points of the copy that were used)"), s.overlap_percent, percent, 2});
    table.rows.push_back({LT_TEXT("Engine", "Points used"), s.points_used, {}});
    table.rows.push_back({LT_TEXT("Engine", "Points left out"), s.points_excluded, {}});
    return table;
}

Value shortVerdict(const std::optional<Verdict>& verdict)
{
    return verdict ? Value(shortName(*verdict)) : Value();
}

report::Table zonesTable(const CompareResult& result)
{
    const bool named = !result.parameters.zones.empty();
    report::Table table{LT_TEXT("Engine", "Zones along the axis"),
                        {LT_TEXT("Engine", "from (mm)"), LT_TEXT("Engine", "to (mm)"), LT_TEXT("Engine", "mean (mm)"),
                         LT_TEXT("Engine", "U (mm)"), LT_TEXT("Engine", "std. dev. (mm)"), LT_TEXT("Engine", "points")},
                        {},
                        {2, 2, 4, 4, 4, 0}};
    if (named) {
        table.columns.insert(table.columns.begin(), LT_TEXT("Engine", "name"));
        table.decimals.insert(table.decimals.begin(), 0);
        table.columns.push_back(LT_TEXT("Engine", "lower (mm)"));
        table.columns.push_back(LT_TEXT("Engine", "upper (mm)"));
        table.decimals.insert(table.decimals.end(), {4, 4});
    }
    if (result.verdict) {
        table.columns.push_back(LT_TEXT("Engine", "verdict"));
        table.decimals.push_back(0);
    }
    for (const Zone& zone : result.zones) {
        std::vector<Value> row{zone.z_start_mm,     zone.z_end_mm, zone.mean_mm,
                               zone.uncertainty_mm, zone.std_mm,   zone.points};
        if (named) {
            row.insert(row.begin(), zone.name);
            row.push_back(given(zone.lower_mm));
            row.push_back(given(zone.upper_mm));
        }
        if (result.verdict) row.push_back(shortVerdict(zone.verdict));
        table.rows.push_back(std::move(row));
    }
    return table;
}

report::Table findingsTable(const CompareResult& result)
{
    report::Table table{LT_TEXT("Engine", "What differs"),
                        {LT_TEXT("Engine", "difference"), LT_TEXT("Engine", "from (mm)"), LT_TEXT("Engine", "to (mm)"),
                         LT_TEXT("Engine", "value (mm)"), LT_TEXT("Engine", "U (mm)"), LT_TEXT("Engine", "limit (mm)"),
                         LT_TEXT("Engine", "verdict")},
                        {},
                        {0, 2, 2, 4, 4, 4, 0}};
    for (const Finding& finding : result.findings)
        table.rows.push_back({name(finding.kind), given(finding.z_start_mm), given(finding.z_end_mm), finding.value_mm,
                              finding.uncertainty_mm, given(finding.limit_mm), shortVerdict(finding.verdict)});
    return table;
}

report::QuantityTable alignmentTable(const CompareResult& result)
{
    const Alignment& alignment = result.alignment;
    const bool axial = alignment.reference_axis.has_value();
    const AlignmentUncertainty& u = alignment.uncertainty;
    return {LT_TEXT("Engine", "Alignment"),
            {{LT_TEXT("Engine", "Method"), methodName(result.method_used), {}},
             {LT_TEXT("Engine", "Converged"), alignment.converged, {}},
             {LT_TEXT("Engine", "Iterations"), std::int64_t{alignment.iterations}, {}},
             {axial ? LT_TEXT("Engine", "Uncertainty along the axis (k = 2)")
                    : LT_TEXT("Engine", "Uncertainty, largest direction (k = 2)"),
              u.axial_um, um, 2},
             {axial ? LT_TEXT("Engine", "Uncertainty across the axis (k = 2)")
                    : LT_TEXT("Engine", "Uncertainty across it (k = 2)"),
              u.radial_um, um, 2},
             {axial ? LT_TEXT("Engine", "Uncertainty of the axis's direction (k = 2)")
                    : LT_TEXT("Engine", "Uncertainty of the rotation (k = 2)"),
              u.axis_deg, LT_TEXT("Engine", "°"), 5}}};
}

report::QuantityTable paperTable(const CompareResult& result)
{
    return {LT_TEXT("Engine", "Nearest-point figure, as in the source paper"),
            {{LT_TEXT("Engine", "Cloud-to-cloud RMSE"), result.cloud_to_cloud_rmse_mm, mm, 4},
             {LT_TEXT("Engine", "Its floor: what sampling alone gives"), result.sampling_floor_mm, mm, 4}}};
}

report::Table freeMotionsTable(const CompareResult& result)
{
    report::Table table{
        LT_TEXT("Engine", "Motions the geometry does not determine"),
        {LT_TEXT("Engine", "motion"), LT_TEXT("Engine", "direction x"), LT_TEXT("Engine", "y"), LT_TEXT("Engine", "z"),
         LT_TEXT("Engine", "through x (mm)"), LT_TEXT("Engine", "y (mm)"), LT_TEXT("Engine", "z (mm)")},
        {},
        {0, 5, 5, 5, 3, 3, 3}};
    for (const FreeMotion& motion : result.alignment.free_motions)
        table.rows.push_back({motion.kind == FreeMotion::Kind::Rotation ? LT_TEXT("Engine", "rotation")
                                                                        : LT_TEXT("Engine", "translation"),
                              motion.direction.x(), motion.direction.y(), motion.direction.z(), motion.point_mm.x(),
                              motion.point_mm.y(), motion.point_mm.z()});
    return table;
}

report::Table transformTable(const CompareResult& result)
{
    report::Table table{
        LT_TEXT("Engine", "From the copy's coordinates to the original's"),
        {LT_TEXT("Engine", "x"), LT_TEXT("Engine", "y"), LT_TEXT("Engine", "z"), LT_TEXT("Engine", "shift (mm)")},
        {},
        {9, 9, 9, 6}};
    const Eigen::Matrix4d matrix = result.alignment.reference_T_copy.matrix();
    for (int row = 0; row < 3; ++row)
        table.rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    return table;
}

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
    if (result.meridian) {
        section.blocks.push_back(deviationAlongAxis(result, language));
        section.blocks.push_back(magnifiedMeridian(result, language));
    }
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
        case Finding::Kind::Step: return LT_TEXT("Engine", "Step {value} ± {uncertainty} mm · z {from}-{to} mm");
        case Finding::Kind::Taper: return LT_TEXT("Engine", "Taper {value} ± {uncertainty} mm · z {from}-{to} mm");
        case Finding::Kind::Barrel:
            return finding.value_mm < 0 ? LT_TEXT("Engine", "Saddle {value} ± {uncertainty} mm · z {from}-{to} mm")
                                        : LT_TEXT("Engine", "Barrel {value} ± {uncertainty} mm · z {from}-{to} mm");
        case Finding::Kind::Bump:
            return finding.z_start_mm ? LT_TEXT("Engine", "Bump {value} ± {uncertainty} mm · z {from}-{to} mm")
                                      : LT_TEXT("Engine", "Bump {value} ± {uncertainty} mm at X {x} Y {y} Z {z}");
        case Finding::Kind::Missing: return LT_TEXT("Engine", "No data of the copy · z {from}-{to} mm");
    }
    return {};
}

report::Finding findingOf(const Finding& finding, const Language& language)
{
    report::Finding said;
    said.pattern = patternOf(finding);
    const std::string plus = finding.value_mm > 0 ? "+" : "";
    said.values = {{"value", plus + fixed(finding.value_mm, 3, language)},
                   {"uncertainty", fixed(finding.uncertainty_mm, 3, language)},
                   {"x", fixed(finding.point_mm.x(), 1, language)},
                   {"y", fixed(finding.point_mm.y(), 1, language)},
                   {"z", fixed(finding.point_mm.z(), 1, language)}};
    if (finding.z_start_mm && finding.z_end_mm) {
        said.values.emplace_back("from", fixed(*finding.z_start_mm, 1, language));
        said.values.emplace_back("to", fixed(*finding.z_end_mm, 1, language));
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

}  // namespace

report::Answer answer(const CompareResult& result, const Language& language)
{
    const DeviationStatistics& s = result.statistics;
    const bool by_surface = result.worst && result.parameters.verdict_rule == VerdictRule::Surface;
    report::Answer answer;
    answer.unit = mm;
    answer.verdict = result.verdict;
    if (by_surface) {
        const WorstPlace& worst = *result.worst;
        answer.quantity = LT_TEXT("Engine", "Worst local deviation");
        answer.value = worst.deviation_mm;
        answer.expanded_uncertainty = worst.uncertainty_mm;
        answer.is_signed = result.has_sign;
        answer.decimals = 3;
        if (worst.z_mm) answer.subject = "z\u00A0" + fixed(*worst.z_mm, 1, language) + "\u00A0mm";
        if (worst.z_mm && worst.angle_deg) answer.subject += ", " + fixed(*worst.angle_deg, 0, language) + "°";
        addLimits(result, answer);
    } else {
        answer.quantity = LT_TEXT("Engine", "RMS deviation");
        answer.value = s.rmse_mm;
        answer.decimals = 4;
    }
    const std::string plus = s.mean_mm > 0 ? "+" : "";
    answer.values = {{"mean", plus + fixed(s.mean_mm, 4, language)},
                     {"rms", fixed(s.rmse_mm, 4, language)},
                     {"scatter", fixed(result.scatter_mm, 4, language)},
                     {"method", methodName(result.method_used)}};
    if (!result.has_sign)
        answer.sentence = LT_TEXT("Engine", "{method}");
    else if (by_surface)
        answer.sentence =
            LT_TEXT("Engine", "RMS {rms} mm · mean {mean} mm · noise of the scans {scatter} mm · {method}");
    else if (result.within_tolerance_percent && result.parameters.tolerance_mm) {
        answer.sentence =
            LT_TEXT("Engine", "mean {mean} mm · {method} · {share} % of the points within ±{tolerance} mm");
        answer.values.emplace_back("share", fixed(*result.within_tolerance_percent, 1, language));
        answer.values.emplace_back("tolerance", *result.parameters.tolerance_mm);
    } else
        answer.sentence = LT_TEXT("Engine", "mean {mean} mm · {method}");
    for (const Finding& finding : result.findings)
        if (answer.findings.size() < 3) answer.findings.push_back(findingOf(finding, language));
    return answer;
}

report::Section compareSummary(const CompareResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language), verdictTable(result)}};
    if (!result.findings.empty()) section.blocks.push_back(findingsTable(result));
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
    document.sections = {compareSummary(result, language),
                         whereSection(result, language, std::move(pictures)),
                         certaintySection(result),
                         {LT_TEXT("Engine", "Method and parameters"),
                          {report::parametersTable(result.parameters, language), transformTable(result)}}};
    return document;
}

}  // namespace lathelier::registration
