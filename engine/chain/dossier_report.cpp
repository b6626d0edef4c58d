#include "engine/chain/dossier_report.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"

namespace lathelier::chain {
namespace {

constexpr std::size_t shownOfDigest = 12;

std::int64_t countOf(const Dossier& dossier, StepState state)
{
    return std::count_if(dossier.steps.begin(), dossier.steps.end(),
                         [state](const ChainStep& step) { return step.state == state; });
}

std::optional<double> toleranceOf(const Dossier& dossier)
{
    const ChainStep* const copy = dossier.step("copy");
    const Value* const stated = copy ? find(copy->parameters, "tolerance_mm") : nullptr;
    const auto* const tolerance_mm = stated ? std::get_if<double>(stated) : nullptr;
    return tolerance_mm ? std::optional(*tolerance_mm) : std::nullopt;
}

/// The largest deviation of the copy; null: no copy.
const TracedNumber* worstOf(const Dossier& dossier)
{
    for (const TracedNumber& number : dossier.numbers)
        if (number.pointer == "/worst/deviation_mm" && number.step == "copy") return &number;
    return nullptr;
}

/// The largest deviation of the copy against its tolerance, if both exist.
void addCopy(const Dossier& dossier, report::Answer& answer)
{
    const TracedNumber* const worst = worstOf(dossier);
    if (!worst) return;
    answer.quantity = LT_TEXT("Engine", "Largest deviation of the copy");
    answer.value = worst->value;
    answer.expanded_uncertainty = worst->uncertainty;
    answer.unit = millimetre;
    answer.is_signed = true;
    if (const auto tolerance_mm = toleranceOf(dossier)) {
        answer.lower_limit = -*tolerance_mm;
        answer.upper_limit = *tolerance_mm;
    }
}

/// Unit of a number by its key, or by the last part of its place.
Text unitOf(const std::string& key)
{
    static const std::vector<std::pair<const char*, Text>> units{{"_mm3", unit::mm3},
                                                                 {"_mm", millimetre},
                                                                 {"_um", unit::um},
                                                                 {"_hz", unit::hz},
                                                                 {"_rpm", LT_TEXT("Engine", "1/min")},
                                                                 {"_s", unit::s}};
    for (const auto& [ending, unit] : units)
        if (key.ends_with(ending)) return unit;
    return {};
}

}  // namespace

Text titleOf(const std::string& step)
{
    if (step == "recognise") return LT_TEXT("Engine", "Recognise the scan");
    if (step == "draw") return LT_TEXT("Engine", "Drawing and CAD");
    if (step == "machine") return LT_TEXT("Engine", "Machine");
    if (step == "speeds") return LT_TEXT("Engine", "Stable depths and speeds");
    if (step == "program") return LT_TEXT("Engine", "Turning program");
    if (step == "deflection") return LT_TEXT("Engine", "Deflection");
    if (step == "deflection_2") return LT_TEXT("Engine", "Deflection, second clamping");
    if (step == "surface") return LT_TEXT("Engine", "Photographs of the surface");
    if (step == "corrected_check") return LT_TEXT("Engine", "Check of the corrected program");
    if (step == "copy") return LT_TEXT("Engine", "Comparison of the copy");
    return LT_TEXT("Engine", "Predicted and measured");
}

report::Table stepsTable(const Dossier& dossier)
{
    report::Table table{LT_TEXT("Engine", "Steps"),
                        {LT_TEXT("Engine", "Step"), LT_TEXT("Engine", "State"), LT_TEXT("Engine", "Made")},
                        {},
                        {}};
    for (const ChainStep& step : dossier.steps) {
        std::string made;
        for (const InputFile& file : step.outputs) made += (made.empty() ? "" : ", ") + file.path;
        table.rows.push_back({titleOf(step.id), nameOf(standingOf(step)), made});
    }
    return table;
}

report::Table filesTable(const Dossier& dossier)
{
    report::Table table{LT_TEXT("Engine", "Files of the chain"),
                        {LT_TEXT("Engine", "Step"), LT_TEXT("Engine", "Taken or made"), LT_TEXT("Engine", "File"),
                         LT_TEXT("Engine", "SHA-256, first digits")},
                        {},
                        {}};
    for (const ChainStep& step : dossier.steps) {
        for (const InputFile& file : step.inputs)
            table.rows.push_back(
                {titleOf(step.id), LT_TEXT("Engine", "taken"), file.path, file.sha256.substr(0, shownOfDigest)});
        for (const InputFile& file : step.outputs)
            table.rows.push_back(
                {titleOf(step.id), LT_TEXT("Engine", "made"), file.path, file.sha256.substr(0, shownOfDigest)});
    }
    return table;
}

report::Table numbersTable(const Dossier& dossier)
{
    report::Table table{
        LT_TEXT("Engine", "Numbers and where they stand"),
        {LT_TEXT("Engine", "File"), LT_TEXT("Engine", "Place"), LT_TEXT("Engine", "Value"), LT_TEXT("Engine", "Unit"),
         LT_TEXT("Engine", "U"), LT_TEXT("Engine", "Unit"), LT_TEXT("Engine", "k"), LT_TEXT("Engine", "Place of U")},
        {},
        {0, 0, 4, 0, 4, 0, 0, 0}};
    for (const TracedNumber& number : dossier.numbers) {
        const bool is_stated = number.uncertainty.has_value();
        table.rows.push_back({number.file, number.pointer, number.value, unitOf(number.key),
                              is_stated ? Value(*number.uncertainty) : Value(),
                              is_stated ? Value(unitOf(number.uncertainty_pointer)) : Value(),
                              is_stated ? Value(number.coverage_factor) : Value(), number.uncertainty_pointer});
    }
    return table;
}

report::Answer answer(const Dossier& dossier)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Copy of a part");
    answer.verdict = dossier.coverVerdict();
    addCopy(dossier, answer);
    if (answer.verdict && answer.verdict != dossier.settledVerdict())
        answer.verdict_words = *answer.verdict == Verdict::Fail ? LT_TEXT("Engine", "✗ a step is out")
                                                                : LT_TEXT("Engine", "? a step is undecided");
    answer.sentence = LT_TEXT("Engine", "{done} of {steps} steps done, {missing} missing, {failed} failed.");
    answer.values = {{"done", countOf(dossier, StepState::Done)},
                     {"steps", static_cast<std::int64_t>(dossier.steps.size())},
                     {"missing", countOf(dossier, StepState::Missing)},
                     {"failed", countOf(dossier, StepState::Failed) + countOf(dossier, StepState::NotReached)}};
    for (const TracedNumber& number : dossier.numbers)
        if (number.step == "proof" && number.pointer == "/largest_normalized_error")
            answer.findings.push_back(
                {LT_TEXT("Engine", "Predicted and measured: |E_n| {error:2}, at most 1 is agreement"),
                 {{"error", std::abs(number.value)}},
                 std::abs(number.value) <= 1 ? Verdict::Pass : Verdict::Fail,
                 {}});
    if (const auto finding = copyFinding(dossier); finding && !finding->verdict) answer.findings.push_back(*finding);
    for (const ChainStep& step : dossier.steps)
        if (const StepStanding standing = standingOf(step); standing.verdict && !standing.isSound()) {
            if (dossier.isCorrected(step)) {
                answer.findings.push_back({LT_TEXT("Engine", "{step}: out of tolerance as programmed, and corrected"),
                                           {{"step", titleOf(step.id)}},
                                           std::nullopt,
                                           {}});
                continue;
            }
            answer.findings.push_back({LT_TEXT("Engine", "{step}: {state}"),
                                       {{"step", titleOf(step.id)}, {"state", nameOf(standing)}},
                                       standing.verdict,
                                       {}});
        }
    for (const ChainStep& step : dossier.steps)
        if (step.state == StepState::Failed && (step.error || !step.remarks.empty()))
            answer.findings.push_back(
                {LT_TEXT("Engine", "{step}: {error}"),
                 {{"step", titleOf(step.id)}, {"error", step.error ? text(*step.error) : step.remarks.back()}},
                 std::nullopt,
                 {}});
    return answer;
}

std::optional<report::Finding> copyFinding(const Dossier& dossier)
{
    const TracedNumber* const worst = worstOf(dossier);
    if (!worst) return std::nullopt;
    report::Finding finding;
    finding.values = {{"worst", worst->value}};
    if (const auto tolerance_mm = toleranceOf(dossier)) {
        finding.pattern = LT_TEXT("Engine", "The copy: largest deviation {worst:3} mm, limit ± {tolerance:3} mm");
        finding.values.emplace_back("tolerance", *tolerance_mm);
        finding.verdict = dossier.settledVerdict();
    } else {
        finding.pattern =
            LT_TEXT("Engine", "The copy: largest deviation {worst:3} mm; no limit is given, so it is not judged");
    }
    return finding;
}

}  // namespace lathelier::chain
