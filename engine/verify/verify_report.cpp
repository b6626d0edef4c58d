#include "engine/verify/verify_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace lathelier {
namespace {

/// Two digits are enough, and the power of ten is what matters: "3.1e-14 mm".
std::string size(double value, Text unit)
{
    std::string result = fmt::format("{:.1e}", value);
    if (!unit.empty()) result.append("\u00A0").append(unit.english);
    return result;
}

Paragraph whereNist(const VerifyResult& result)
{
    if (result.reference_data.empty())
        return {LT_TEXT("Engine", "All sets are built in; no folder with further ones was named."), {}};
    return {LT_TEXT("Engine", "NIST reference sets from {path}; the other sets are built in."),
            {{"path", result.reference_data}}};
}

Paragraph howVerified()
{
    return {LT_TEXT("Engine",
                    "Each set is fitted anew by this program on this computer. The answers follow from the way the "
                    "data are made (closed forms), from trying all possible contacts, or are NIST's."),
            {}};
}

}  // namespace

Headline headline(const VerifyResult& result, const Language& language)
{
    const auto count = static_cast<std::int64_t>(result.kinds.size());
    const auto failed = static_cast<std::int64_t>(
        std::count_if(result.kinds.begin(), result.kinds.end(), [](const VerifyKind& k) { return !k.pass; }));
    const Text pattern = failed == 0
                             ? LT_TEXT("Engine", "{count} kinds of reference data refitted: all answers agree")
                             : LT_TEXT("Engine", "{failed} of {count} kinds of reference data miss their answers");
    return {fill(text(pattern, language), {{"count", count}, {"failed", failed}}, language), result.pass};
}

Table verifyTable(const VerifyResult& result)
{
    Table table{LT_TEXT("Engine", "Reference data refitted"),
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

Section verifySummary(const VerifyResult& result, const Language& language)
{
    return {LT_TEXT("Engine", "Result"), {headline(result, language), verifyTable(result), whereNist(result)}};
}

Document verifyReport(const VerifyResult& result, const Language& language)
{
    Document document;
    document.title = LT_TEXT("Engine", "Verification of the installation");
    document.sections = {verifySummary(result, language)};
    document.sections[0].blocks.push_back(howVerified());
    document.verified = true;
    return document;
}

void quoteVerification(Document& document, const Progress& progress, const Language& language)
{
    if (document.verified || document.verification.empty()) return;
    document.verified = true;
    const VerifyResult result = verify(document.verification, {}, progress);
    const Paragraph said{Text{"{summary}"}, {{"summary", headline(result, language).text}}};
    document.sections.push_back({LT_TEXT("Engine", "Verification of the installation"),
                                 {said, verifyTable(result), whereNist(result), howVerified()}});
}

}  // namespace lathelier
