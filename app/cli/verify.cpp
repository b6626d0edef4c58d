// verify: refits reference data with known answers, here and now.
#include "engine/form/verify.h"

#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/form/verify_json.h"
#include "engine/report/plain_text.h"
#include "engine/report/verify_report.h"

namespace lathelier::cli {
namespace {

constexpr const char* nistKey = "nist_directory";

void runVerify(const Request& request, Inputs&, const Progress& progress, Answer& answer)
{
    const Value* directory = find(request.parameters, nistKey);
    const auto* word = directory ? std::get_if<std::string>(directory) : nullptr;
    const auto result = std::make_shared<VerifyResult>(
        verify(word ? *word : std::string(), progress.part(0, 1, LT_TEXT("Engine", "Verifying"))));
    answer.json = [result] { return toJson(*result); };
    answer.report = [result] { return verifyReport(*result); };
    answer.pass = result->pass;
    answer.always_strict = true;
    answer.summary = toPlainText(verifySummary(*result));
}

Option nistOption()
{
    FieldInfo info;
    info.key = nistKey;
    info.kind = FieldInfo::Kind::Word;
    info.label = LT_TEXT("Engine", "NIST sets");
    info.help =
        LT_TEXT("Engine", "Folder with NIST's circle sets (.ds, .fit); by default ../shared/data if it is there.");
    return {info, std::string()};
}

}  // namespace

Verb verifyVerb()
{
    return {"verify", "Refit reference data with known answers and say how far off this installation is.",
            {},       {nistOption()},
            {},       {},
            true,     runVerify};
}

}  // namespace lathelier::cli
