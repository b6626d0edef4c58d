// verify: refits reference data with known answers, here and now.
#include "engine/verify/verify.h"

#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/report/plain_text.h"
#include "engine/verify/verify_json.h"
#include "engine/verify/verify_report.h"

namespace lathelier::cli {
namespace {

constexpr const char* referenceKey = "reference_data";

void runVerify(const Request& request, io::InputFiles&, const Progress& progress, Answer& answer)
{
    const Value* directory = find(request.parameters, referenceKey);
    const auto* word = directory ? std::get_if<std::string>(directory) : nullptr;
    const auto result = std::make_shared<verify::VerifyResult>(verify::verify(
        verify::verifyParts(), word ? *word : std::string(), progress.part(0, 1, LT_TEXT("Engine", "Verifying"))));
    answer.json = [result] { return toJson(*result); };
    answer.report = [result] { return verify::verifyReport(*result); };
    answer.pass = result->pass;
    answer.always_strict = true;
    answer.summary = report::toPlainText(verify::verifySummary(*result));
}

Option referenceOption()
{
    FieldInfo info;
    info.key = referenceKey;
    info.kind = FieldInfo::Kind::Word;
    info.label = LT_TEXT("Engine", "Reference data");
    info.help = LT_TEXT("Engine", "Folder with NIST's circle sets (.ds, .fit), refitted beside the built-in ones.");
    info.optional = true;
    return {info, {}};
}

}  // namespace

Verb verifyVerb()
{
    return {"verify", "Refit reference data with known answers and say how far off this installation is.",
            {},       {referenceOption()},
            {},       {},
            true,     runVerify};
}

}  // namespace lathelier::cli
