#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/batch/batch.h"
#include "engine/report/plain_text.h"

namespace lathelier::batch {
namespace {

constexpr std::size_t mostFailuresShown = 100;

std::int64_t countOf(const BatchResult& result, Standing standing)
{
    return result.verdicts[static_cast<std::size_t>(standing)];
}

report::QuantityTable countsOf(const BatchResult& result)
{
    report::QuantityTable table;
    const auto row = [&table](Text name, std::int64_t count) { table.rows.push_back({name, count, {}, 0}); };
    row(LT_TEXT("Engine", "Parts"), result.parts);
    row(LT_TEXT("Engine", "within tolerance"), countOf(result, Standing::Pass));
    row(LT_TEXT("Engine", "out of tolerance"), countOf(result, Standing::Fail));
    row(LT_TEXT("Engine", "undecided"), countOf(result, Standing::Undecided));
    row(LT_TEXT("Engine", "answered without a verdict"), countOf(result, Standing::None));
    row(LT_TEXT("Engine", "without an answer"), result.failed());
    row(LT_TEXT("Engine", "with the content of another"), result.duplicates);
    row(LT_TEXT("Engine", "taken over from an earlier run"), result.taken_over);
    return table;
}

report::Table failuresTable(const BatchResult& result)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Parts without an answer");
    table.columns = {LT_TEXT("Engine", "File"), LT_TEXT("Engine", "Exit code"), LT_TEXT("Engine", "Reason")};
    table.decimals = {0, 0, 0};
    for (std::size_t i = 0; i < std::min(result.failures.size(), mostFailuresShown); ++i) {
        const Failure& one = result.failures[i];
        table.rows.push_back({one.path, std::int64_t{one.exit_code}, one.message});
    }
    return table;
}

}  // namespace

Json toJson(const BatchResult& result)
{
    Json failures = Json::array();
    for (std::size_t i = 0; i < std::min(result.failures.size(), mostFailuresShown); ++i)
        failures.push_back(toJson(result.failures[i]));
    return {{"task", result.task},
            {"recipe_sha256", result.recipe_sha256},
            {"parts", result.parts},
            {"computed", result.computed},
            {"taken_over", result.taken_over},
            {"failed", result.failed()},
            {"duplicates", result.duplicates},
            {"verdicts",
             {{"pass", countOf(result, Standing::Pass)},
              {"fail", countOf(result, Standing::Fail)},
              {"undecided", countOf(result, Standing::Undecided)},
              {"none", countOf(result, Standing::None)}}},
            {"failures", std::move(failures)},
            {"results", result.results_file},
            {"failures_file", result.failures_file}};
}

report::Document batchReport(const BatchResult& result)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "A recipe over many parts");
    report::Section section;
    section.title = LT_TEXT("Engine", "Overview");
    section.blocks.emplace_back(countsOf(result));
    if (!result.failures.empty()) section.blocks.emplace_back(failuresTable(result));
    document.sections.push_back(std::move(section));
    return document;
}

std::string batchSummary(const BatchResult& result)
{
    return report::toPlainText(report::Section{{}, {countsOf(result)}}) + result.results_file + "\n";
}

}  // namespace lathelier::batch
