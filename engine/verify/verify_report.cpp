#include "engine/verify/verify_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace lathelier::verify {
namespace {

/// Two significant digits with the power of ten: "3.1e-14 mm".
std::string size(double value, Text unit)
{
    std::string result = fmt::format("{:.1e}", value);
    if (!unit.empty()) result.append("\u00A0").append(unit.english);
    return result;
}

report::Paragraph whereNist(const VerifyResult& result)
{
    if (result.reference_data.empty())
        return {LT_TEXT("Engine", "All sets are built in; no folder with further ones was named."), {}};
    return {LT_TEXT("Engine", "NIST reference sets from {path}; the other sets are built in."),
            {{"path", result.reference_data}}};
}

report::Paragraph howVerified()
{
    return {LT_TEXT("Engine",
                    "Each set is fitted anew by this program on this computer. The answers follow from the way the "
                    "data are made (closed forms), from trying all possible contacts, or are NIST's."),
            {}};
}

}  // namespace

report::Answer answer(const VerifyResult& result)
{
    const auto count = static_cast<std::int64_t>(result.kinds.size());
    const auto failed = static_cast<std::int64_t>(
        std::count_if(result.kinds.begin(), result.kinds.end(), [](const VerifyKind& k) { return !k.pass; }));
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Reference data refitted");
    answer.verdict = result.pass ? Verdict::Pass : Verdict::Fail;
    answer.sentence = failed == 0 ? LT_TEXT("Engine", "{count} kinds of reference data refitted: all answers agree")
                                  : LT_TEXT("Engine", "{failed} of {count} kinds of reference data miss their answers");
    answer.values = {{"count", count}, {"failed", failed}};
    return answer;
}

report::Table verifyTable(const VerifyResult& result)
{
    report::Table table{LT_TEXT("Engine", "Reference data refitted"),
                        {LT_TEXT("Engine", "kind"), LT_TEXT("Engine", "sets"), LT_TEXT("Engine", "largest deviation"),
                         LT_TEXT("Engine", "limit"), LT_TEXT("Engine", "verdict")},
                        {},
                        {}};
    for (const VerifyKind& kind : result.kinds)
        table.rows.push_back({kind.name, std::int64_t{kind.sets}, size(kind.largest_deviation, kind.unit),
                              size(kind.limit, kind.unit),
                              kind.pass ? LT_TEXT("Engine", "pass") : LT_TEXT("Engine", "fail")});
    return table;
}

report::Section verifySummary(const VerifyResult& result)
{
    return {LT_TEXT("Engine", "Result"), {answer(result), verifyTable(result), whereNist(result)}};
}

report::Document verifyReport(const VerifyResult& result)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Verification of the installation");
    document.sections = {verifySummary(result)};
    document.sections[0].blocks.push_back(howVerified());
    document.verified = true;
    return document;
}

void quoteVerification(report::Document& document, const Progress& progress)
{
    if (document.verified || document.verification.empty()) return;
    document.verified = true;
    const VerifyResult result = verify(document.verification, {}, progress);
    const report::Answer summary = answer(result);
    const report::Paragraph summarySentence{summary.sentence, summary.values};
    document.sections.push_back({LT_TEXT("Engine", "Verification of the installation"),
                                 {summarySentence, verifyTable(result), whereNist(result), howVerified()}});
}

}  // namespace lathelier::verify
