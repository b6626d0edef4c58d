#include "engine/verify/verify_task.h"

#include <nlohmann/json.hpp>

#include "engine/verify/verify.h"
#include "engine/verify/verify_json.h"
#include "engine/verify/verify_report.h"

namespace lathelier::verify {
namespace {

struct VerifyQuestion {
    std::string kind = allTopics;  ///< topic of the checks
    std::string reference_data;    ///< folder; empty: the built-in data only
};

const std::vector<Field<VerifyQuestion>>& fieldsOf(const VerifyQuestion*)
{
    static const std::vector<Field<VerifyQuestion>> all{
        choice("kind", &VerifyQuestion::kind,
               {{allTopics, LT_TEXT("Engine", "all")},
                {"form", LT_TEXT("Engine", "form")},
                {"registration", LT_TEXT("Engine", "registration")},
                {"dynamics", LT_TEXT("Engine", "dynamics")},
                {"deflection", LT_TEXT("Engine", "deflection")}},
               Label{LT_TEXT("Engine", "Kind"), LT_TEXT("Engine", "Which checks are run.")}),
        field("reference_data", &VerifyQuestion::reference_data,
              Label{LT_TEXT("Engine", "Reference data"),
                    LT_TEXT("Engine",
                            "Folder with NIST's circle sets (.ds, .fit), refitted beside the built-in ones.")})};
    return all;
}

task::Outcome outcomeOf(const std::shared_ptr<const VerifyResult>& result)
{
    task::Outcome all;
    all.result = result;
    all.verdict = result->pass ? Verdict::Pass : Verdict::Fail;
    all.json = [result] { return toJson(*result); };
    all.answer = [result](const Language&) { return answer(*result); };
    all.summary = [result](const Language&) { return verifySummary(*result); };
    all.report = [result](const Language&) { return verifyReport(*result); };
    return all;
}

}  // namespace

const task::Task& verifyTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "verify";
        made.title = LT_TEXT("Engine", "Verify installation");
        made.summary = "Refit reference data with known answers and say how far off this installation is.";
        made.always_strict = true;
        task::askFor<VerifyQuestion>(made);
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores&, task::Sources&,
                      const Progress& progress) {
            const auto question = fromValues<VerifyQuestion>(state.parameters);
            return outcomeOf(std::make_shared<const VerifyResult>(verify(
                partsOf(question.kind), question.reference_data, progress.part(0, 1, LT_TEXT("Engine", "Verifying")))));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::verify
