#include "engine/features/comparison/shaft_comparison.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <variant>

#include "engine/core/verdict_json.h"
#include "engine/features/comparison/mark_matching.h"
#include "engine/features/comparison/shaft_mesh.h"
#include "engine/features/features_codes.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/compare_report.h"
#include "engine/registration/drawn_reference.h"
#include "engine/registration/verdict/verdict.h"
#include "engine/report/quantity_table.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::features {
namespace {

void addNew(const Notes& more, Notes& notes)
{
    Notes fresh;
    for (const Note& note : more)
        if (!contains(notes, note.code)) fresh.push_back(note);
    notes.insert(notes.end(), fresh.begin(), fresh.end());
}

/// Without a recognition every size with a limit is undecided.
std::vector<ComparedRow> comparedRowsOf(const Shaft& nominal, const Scan& copy, registration::CompareResult& surface,
                                        const Progress& progress)
{
    RecognitionParameters parameters;
    parameters.snap = Snap::None;
    parameters.scanner_accuracy_mm = surface.parameters.scanner_accuracy_mm;
    Recognition measured;
    try {
        measured = recognize(copy, parameters, progress);
    } catch (const Error& error) {
        surface.notes.push_back({notes::sizesNotRecognized, {{"reason", std::string(error.code().key)}}});
        return compareRows(nominal, {}, surface.parameters.decision);
    }
    addNew(measured.notes, surface.notes);
    const Eigen::Isometry3d nominal_T_part = surface.alignment.reference_T_copy * measured.part_T_scan.inverse();
    for (Note& note : notesOfMarks(nominal, measured, nominal_T_part)) surface.notes.push_back(std::move(note));
    return compareRows(nominal, measured, surface.parameters.decision, nominal_T_part);
}

Value verdictText(const std::optional<Verdict>& verdict)
{
    return verdict ? Value(name(*verdict)) : Value();
}

report::Finding findingOf(const ShaftComparison& result, const ComparedRow& row)
{
    report::Finding finding;
    finding.place.z_mm = placeOf(result, row);
    finding.verdict = row.verdict;
    finding.values = {{"row", row.row}, {"quantity", quantityName(row)}};
    if (row.bore) finding.values.emplace_back("bore", *row.bore);
    if (!row.deviation_mm) {
        finding.pattern = row.bore ? LT_TEXT("Engine", "Bore {bore}, row {row}, {quantity}: not measured")
                                   : LT_TEXT("Engine", "Row {row}, {quantity}: not measured");
        return finding;
    }
    finding.pattern = row.bore ? LT_TEXT("Engine", "Bore {bore}, row {row}, {quantity} {deviation_mm:+3} mm")
                               : LT_TEXT("Engine", "Row {row}, {quantity} {deviation_mm:+3} mm");
    finding.values.emplace_back("deviation_mm", *row.deviation_mm);
    return finding;
}

/// How far a size is beyond its limits.
double excess_mm(const ComparedRow& row)
{
    double excess = -std::numeric_limits<double>::infinity();
    for (const auto& size : {row.measured_mm, row.smallest_mm, row.largest_mm}) {
        if (!size) continue;
        if (row.upper_mm) excess = std::max(excess, *size - row.nominal_mm - *row.upper_mm);
        if (row.lower_mm) excess = std::max(excess, *row.lower_mm - (*size - row.nominal_mm));
    }
    return excess;
}

/// The sizes that are out, the worst first, then those that are not decided.
std::vector<const ComparedRow*> notWithin(const std::vector<ComparedRow>& rows)
{
    std::vector<const ComparedRow*> found;
    for (const Verdict verdict : {Verdict::Fail, Verdict::Undecided}) {
        const std::size_t before = found.size();
        for (const ComparedRow& row : rows)
            if (row.verdict == verdict) found.push_back(&row);
        std::stable_sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end(),
                         [](const ComparedRow* a, const ComparedRow* b) { return excess_mm(*a) > excess_mm(*b); });
    }
    return found;
}

/// The verdict of both where it is not the surface's, and the sizes that are not within.
void addSizes(const ShaftComparison& result, report::Answer& answer)
{
    constexpr std::size_t mostListedSizes = 3;
    const std::optional<Verdict> sizes = worstVerdict(result.rows);
    if (!sizes) return;
    if (result.verdict != result.surface.verdict) {
        answer.verdict = result.verdict;
        switch (*sizes) {
            case Verdict::Pass: answer.verdict_words = LT_TEXT("Engine", "✓ sizes within tolerance"); break;
            case Verdict::Fail: answer.verdict_words = LT_TEXT("Engine", "✗ sizes out of tolerance"); break;
            case Verdict::Undecided: answer.verdict_words = LT_TEXT("Engine", "? sizes not decided"); break;
        }
    }
    std::vector<report::Finding> findings;
    for (const ComparedRow* row : notWithin(result.rows)) findings.push_back(findingOf(result, *row));
    findings.insert(findings.end(), answer.findings.begin(), answer.findings.end());
    if (findings.size() > mostListedSizes) findings.resize(mostListedSizes);
    answer.findings = std::move(findings);
}

void addSizes(const ShaftComparison& result, report::Section& summary)
{
    if (summary.blocks.empty()) return;
    if (auto* const answer = std::get_if<report::Answer>(&summary.blocks.front())) addSizes(result, *answer);
}

Verdict together(const std::optional<Verdict>& a, Verdict b)
{
    return a ? worse(*a, b) : b;
}

}  // namespace

Interval placeOf(const ShaftComparison& result, const ComparedRow& row)
{
    const Shaft& shaft = result.nominal;
    const auto index = static_cast<std::size_t>(std::max<std::int64_t>(row.row, 1) - 1);
    double from = 0, to = 0;
    if (!row.bore) {
        for (std::size_t i = 0; i <= index && i < shaft.segments.size(); ++i) {
            from = to;
            to += shaft.segments[i].length_mm;
        }
    } else if (const auto number = static_cast<std::size_t>(*row.bore - 1); number < shaft.bores.size()) {
        const ShaftBore& bore = shaft.bores[number];
        const double sense = bore.from == ShaftEnd::Free ? 1 : -1;
        from = to = sense > 0 ? 0 : shaft.length_mm();
        for (std::size_t i = 0; i <= index && i < bore.segments.size(); ++i) {
            from = to;
            to += sense * bore.segments[i].length_mm;
        }
    }
    if (const auto& frame = result.surface.axis_T_reference) {
        from = (*frame * Eigen::Vector3d(0, 0, from)).z();
        to = (*frame * Eigen::Vector3d(0, 0, to)).z();
    }
    return {std::min(from, to), std::max(from, to)};
}

void judgeSurface(ShaftComparison& result, const registration::CompareParameters& parameters, const Progress& progress)
{
    judge(result.surface, parameters, progress);
    result.verdict = worstVerdict(result.rows);
    if (const auto& surface = result.surface.verdict) result.verdict = together(result.verdict, *surface);
}

report::Answer answer(const ShaftComparison& result, const Language& language)
{
    report::Answer answer = registration::answer(result.surface, language);
    addSizes(result, answer);
    return answer;
}

ShaftComparison compareWithShaft(const Shaft& nominal, const Scan& copy,
                                 const registration::CompareParameters& parameters, const Progress& progress,
                                 registration::CompareDetail detail)
{
    ShaftMesh mesh = shaftMesh(nominal, meshingLimits.finest_sagitta_mm, progress.part(0, 0.05));
    const registration::DrawnReference reference{std::move(mesh.scan), closedContour(nominal)};
    ShaftComparison result;
    result.nominal = nominal;
    result.surface = compare(reference, copy, parameters,
                             progress.part(0.05, 0.8, LT_TEXT("Engine", "Comparing the surface")), detail);
    result.rows =
        comparedRowsOf(nominal, copy, result.surface, progress.part(0.8, 1, LT_TEXT("Engine", "Comparing the sizes")));
    result.verdict = worstVerdict(result.rows);
    if (const auto& surface = result.surface.verdict) result.verdict = together(result.verdict, *surface);
    return result;
}

Json toJson(const ShaftComparison& result)
{
    Json json = registration::toJson(result.surface);
    json["surface_verdict"] = json["verdict"];
    json["verdict"] = verdictJson(result.verdict);
    json["rows"] = Json::array();
    for (const ComparedRow& row : result.rows) json["rows"].push_back(nestedJson(describedValues(row)));
    return json;
}

report::Table sizesTable(const ShaftComparison& result)
{
    std::vector<const char*> keys{"row", "named", "nominal_mm", "measured_mm", "deviation_mm", "uncertainty_mm"};
    const auto& rows = result.rows;
    if (std::any_of(rows.begin(), rows.end(), [](const ComparedRow& row) { return row.bore.has_value(); }))
        keys.insert(keys.begin() + 1, "bore");
    if (std::any_of(rows.begin(), rows.end(), [](const ComparedRow& row) { return row.verdict.has_value(); }))
        keys.insert(keys.end(), {"lower_mm", "upper_mm", "judged"});
    return report::listTable<ComparedRow>(LT_TEXT("Engine", "Sizes of the rows"), std::span<const ComparedRow>(rows),
                                          keys);
}

report::Section sizesSection(const ShaftComparison& result)
{
    report::QuantityTable verdicts{LT_TEXT("Engine", "Verdicts"), {}};
    verdicts.rows.push_back({LT_TEXT("Engine", "Surface"), verdictText(result.surface.verdict), {}});
    verdicts.rows.push_back({LT_TEXT("Engine", "Sizes"), verdictText(worstVerdict(result.rows)), {}});
    verdicts.rows.push_back({LT_TEXT("Engine", "Together"), verdictText(result.verdict), {}});
    return {LT_TEXT("Engine", "Sizes against the drawing"), {verdicts, sizesTable(result)}};
}

report::Section surfaceSummary(const ShaftComparison& result, const Language& language)
{
    report::Section summary = compareSummary(result.surface, language);
    addSizes(result, summary);
    return summary;
}

report::Document shaftReport(const ShaftComparison& result, const std::vector<InputFile>& inputs,
                             const Language& language, std::vector<report::Picture> pictures)
{
    report::Document document = compareReport(result.surface, inputs, language, std::move(pictures));
    document.title = LT_TEXT("Engine", "Comparison of a part with its drawing");
    if (!document.sections.empty()) addSizes(result, document.sections.front());
    document.sections.insert(document.sections.begin() + (document.sections.empty() ? 0 : 1), sizesSection(result));
    return document;
}

}  // namespace lathelier::features
