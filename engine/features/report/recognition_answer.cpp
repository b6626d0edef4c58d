#include "engine/features/report/recognition_answer.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/features/report/recognition_quantities.h"

namespace lathelier::features {
namespace {

/// The row with the largest form deviation.
const RecognizedRow* rowWithLargestForm(const Recognition& result)
{
    const auto row =
        std::max_element(result.segments.begin(), result.segments.end(),
                         [](const RecognizedRow& a, const RecognizedRow& b) { return a.form_pv_um < b.form_pv_um; });
    return row == result.segments.end() || row->form_pv_um <= 0 ? nullptr : &*row;
}

std::int64_t suggestionsIn(const Recognition& result)
{
    std::size_t count = 0;
    for (const RecognizedRow& row : result.segments) count += row.suggestions.size();
    return static_cast<std::int64_t>(count);
}

void addFindings(const Recognition& result, report::Answer& answer)
{
    for (const UnexplainedStructure& one : result.unexplained)
        answer.findings.push_back(
            {LT_TEXT("Engine", "Unexplained: {structure} · z {from_mm:1}-{to_mm:1} mm"),
             {{"structure", structureName(one.kind)}, {"from_mm", one.z_start_mm}, {"to_mm", one.z_end_mm}},
             {},
             {Interval{one.z_start_mm, one.z_end_mm}, {}, {}}});
    if (!result.gaps.empty()) {
        const Gap& gap = result.gaps.front();
        answer.findings.push_back({LT_TEXT("Engine", "No data · z {from_mm:1}-{to_mm:1} mm"),
                                   {{"from_mm", gap.z_start_mm}, {"to_mm", gap.z_end_mm}},
                                   {},
                                   {Interval{gap.z_start_mm, gap.z_end_mm}, {}, {}}});
    }
    if (const RecognizedRow* row = rowWithLargestForm(result))
        answer.findings.push_back({LT_TEXT("Engine", "Row {row}: form {form_um:1} µm · z {from_mm:1}-{to_mm:1} mm"),
                                   {{"row", static_cast<std::int64_t>(row - result.segments.data()) + 1},
                                    {"form_um", row->form_pv_um},
                                    {"from_mm", row->z_start_mm},
                                    {"to_mm", row->z_end_mm}},
                                   {},
                                   {Interval{row->z_start_mm, row->z_end_mm}, {}, {}}});
    const std::int64_t count = suggestionsIn(result);
    if (count > 0 && result.parameters.snap == Snap::Suggest)
        answer.findings.push_back({LT_TEXT("Engine", "Nominal sizes suggested: {count}. Accept all"),
                                   {{"count", count}},
                                   {},
                                   {},
                                   {{"snap", std::string("apply")}}});
}

/// Where the part may end, of an end that is not decided: first of all, since the length hangs on it.
void addUndecidedEnds(const Recognition& result, report::Answer& answer)
{
    for (std::size_t i = result.ends.size(); i-- > 0;) {
        const RecognizedEnd& end = result.ends[i];
        if (end.closed_by != "undecided" || !end.span_mm) continue;
        report::Finding finding;
        finding.pattern = i == 0
                              ? LT_TEXT("Engine", "Free end not decided: it lies from z {from_mm:3} to {to_mm:3} mm")
                              : LT_TEXT("Engine", "Chuck end not decided: it lies from z {from_mm:3} to {to_mm:3} mm");
        finding.values = {{"from_mm", end.span_mm->from}, {"to_mm", end.span_mm->to}};
        finding.place.z_mm = end.span_mm;
        answer.findings.insert(answer.findings.begin(), std::move(finding));
    }
    constexpr std::size_t mostFindings = 3;
    if (answer.findings.size() > mostFindings) answer.findings.resize(mostFindings);
}

}  // namespace

int decimalsFor(double uncertainty)
{
    if (!(uncertainty > 0)) return 3;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(uncertainty))) + 1, 2, 4);
}

report::Answer answer(const Recognition& result)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Length");
    answer.unit = unit::mm;
    answer.value = result.length_mm;
    answer.verdict_words = result.complete ? LT_TEXT("Engine", "complete") : LT_TEXT("Engine", "not complete");
    if (result.length_mm && result.length_uncertainty_mm > 0) {
        answer.expanded_uncertainty = result.length_uncertainty_mm;
        answer.decimals = decimalsFor(result.length_uncertainty_mm);
    }
    const auto largest = largestDiameter(result);
    answer.sentence =
        result.length_mm
            ? LT_TEXT("Engine", "Largest diameter {diameter_mm:3} mm ± {uncertainty_um:1} µm · {rows} rows")
            : LT_TEXT("Engine",
                      "An end is not seen · largest diameter {diameter_mm:3} mm ± {uncertainty_um:1} µm · {rows} rows");
    answer.values = {{"diameter_mm", largest ? Value(largest->diameter_mm) : Value()},
                     {"uncertainty_um", largest && largest->uncertainty_um ? Value(*largest->uncertainty_um) : Value()},
                     {"rows", static_cast<std::int64_t>(result.segments.size())}};
    addFindings(result, answer);
    addUndecidedEnds(result, answer);
    return answer;
}

}  // namespace lathelier::features
