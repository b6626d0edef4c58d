// batch RECIPE FILES... --out DIR: a recipe over many parts.
#include "engine/batch/batch.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/cli/recipe_shop.h"
#include "app/cli/verbs.h"
#include "engine/batch/batch_codes.h"
#include "engine/batch/recipe_file.h"
#include "engine/core/core_codes.h"
#include "engine/io/file.h"

namespace lathelier {

namespace cli {
namespace {

struct BatchOptions {
    std::string out;
    std::string shard = "1/1";
    int jobs = 0;
    bool resume = false;
    bool reports = false;
};

const std::vector<Field<BatchOptions>>& fieldsOf(const BatchOptions*)
{
    static const std::vector<Field<BatchOptions>> all{
        field("out", &BatchOptions::out,
              Label{{"Folder of the results"}, {"The folder of the results; made when it is missing."}}),
        field("shard", &BatchOptions::shard,
              Label{{"Share"}, {"Of n processes over the same list the i-th, i/n with i from 1."}}),
        field("jobs", &BatchOptions::jobs, Range{0, 4096},
              Label{{"Jobs"}, {"Parts computed side by side (0: as many as cores). The result is the same."}}),
        field("resume", &BatchOptions::resume,
              Label{{"Continue"}, {"Continue what the folder was made for; RECIPE and FILES may be left out."}}),
        field("reports", &BatchOptions::reports,
              Label{{"Reports"}, {"Write a report of each answered part, reports/NAME.html in the folder."}})};
    return all;
}

batch::RememberedRun runOf(const Request& request, const BatchOptions& options)
{
    batch::RememberedRun run;
    const std::vector<std::string>& operands = request.operands;
    if (options.resume && operands.size() < 2) run = batch::remembered(options.out);
    if (!operands.empty()) run.recipe = operands.front();
    if (operands.size() > 1) run.inputs.assign(operands.begin() + 1, operands.end());
    return run;
}

void requireGiven(const std::string& name, bool given, Value expected)
{
    if (!given)
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", name}, {"found", std::string()}, {"expected", std::move(expected)}});
}

std::shared_ptr<const task::Sources> sourcesOf(const batch::LoadedRecipe& loaded)
{
    auto sources = std::make_shared<task::Sources>();
    sources->inputs.push_back(loaded.file);
    for (const batch::RecipeFile& file : batch::filesOf(loaded.recipe)) {
        std::error_code unknown;
        const auto bytes = std::filesystem::file_size(file.path, unknown);
        sources->inputs.push_back({file.path, unknown ? 0 : static_cast<std::int64_t>(bytes), file.sha256});
    }
    return sources;
}

void runBatchVerb(const batch::Tasks& tasks, const Request& request, const Progress& progress, Answer& answer)
{
    const auto options = fromValues<BatchOptions>(request.parameters);
    requireGiven("--out", !options.out.empty(), LT_TEXT("Engine", "a folder"));
    batch::BatchSettings settings;
    settings.folder = options.out;
    settings.shard = batch::shardFrom(options.shard);
    settings.jobs = options.jobs;
    settings.reports = options.reports;
    settings.complete = completedByRecipe;
    settings.asked = runOf(request, options);
    requireGiven("RECIPE", !settings.asked.recipe.empty(), LT_TEXT("Engine", "a recipe, or --resume"));
    requireGiven("FILES", !settings.asked.inputs.empty(), LT_TEXT("Engine", "files, folders or lists, or --resume"));
    const batch::LoadedRecipe loaded = batch::loadRecipe(settings.asked.recipe, tasks, progress.quiet());
    answer.sources = sourcesOf(loaded);
    const auto result = std::make_shared<const batch::BatchResult>(
        batch::runBatch(settings.asked.inputs, loaded.recipe, settings, progress));
    answer.notes = result->notes;
    answer.json = [result] { return batch::toJson(*result); };
    answer.report = [result] { return batch::batchReport(*result); };
    answer.is_reported = true;
    answer.summary = batch::batchSummary(*result);
    answer.pass = result->pass();
    if (result->failed() > 0)
        answer.errors.emplace_back(
            errors::batchPartsFailed,
            Values{{"failed", result->failed()}, {"parts", result->parts}, {"file", result->failures_file}});
}

}  // namespace

Verb batchVerb(const std::vector<const task::Task*>& tasks)
{
    Verb verb;
    verb.name = "batch";
    verb.summary = "Ask one recipe of many parts, side by side and in shares; what is answered is not computed again.";
    verb.operands = {{"RECIPE", "What --save-recipe of another command wrote.", false, false, true},
                     {"FILES", "Files, folders, or a list: a file a line, or {\"inputs\": {role: file}} a line.", true,
                      false, true}};
    verb.parameters = optionsOf<BatchOptions>();
    verb.parameters.front().is_output = true;
    verb.has_report = true;
    verb.run = [tasks](const Request& request, io::InputFiles&, const Progress& progress, Answer& answer) {
        runBatchVerb(tasks, request, progress, answer);
    };
    return verb;
}

}  // namespace cli
}  // namespace lathelier
