#include "engine/batch/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/batch/batch_codes.h"
#include "engine/io/io_codes.h"
#include "tests/engine/batch/number_task.h"

namespace lathelier::batch {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Without the recipe on its first line.
std::vector<std::string> evaluationsIn(const std::filesystem::path& path)
{
    std::vector<std::string> lines = linesOf(textOf(path));
    if (!lines.empty()) lines.erase(lines.begin());
    return lines;
}

std::string codeOf(const std::function<void()>& work)
{
    try {
        work();
    } catch (const Error& error) {
        return error.code().key;
    }
    return "none";
}

TEST(Batch, lines_are_evaluations_in_the_order_of_the_parts)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 20);
    const BatchResult result = runBatch({(folder / "parts").string()}, recipe, into(folder / "out"));
    EXPECT_EQ(result.parts, 20);
    EXPECT_EQ(result.computed, 20);
    EXPECT_EQ(result.verdicts, (std::array<std::int64_t, 4>{10, 10, 0, 0}));
    EXPECT_EQ(result.pass(), false);
    const std::vector<std::string> lines = linesOf(textOf(result.results_file));
    ASSERT_EQ(lines.size(), 21U);
    const Json head = Json::parse(lines.front());
    EXPECT_EQ(head["sha256"], identityOf(recipe));
    EXPECT_EQ(head["recipe"]["task"], "number");
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const archive::Evaluation one = archive::evaluationFrom(lines[i]);
        EXPECT_EQ(one.recipe_sha256, identityOf(recipe));
        EXPECT_EQ(one.inputs.front().role, "part");
        EXPECT_EQ(Json::parse(one.result)["value_mm"], static_cast<double>(i) - 0.5);
        ASSERT_EQ(one.characteristics.size(), 1U);
        EXPECT_EQ(one.characteristics.front().key, "value_mm");
    }
    EXPECT_EQ(textOf(result.failures_file), "file,exit_code,code,line,column,byte,message\r\n");
}

TEST(Batch, jobs_do_not_change_a_byte)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder, {{"pause_ms", std::int64_t{1}}});
    writeParts(folder, 60);
    writeText(folder / "parts" / "p030.txt", "thirty");
    std::string first;
    for (const int jobs : {1, 2, 4, 7}) {
        const BatchResult result =
            runBatch({(folder / "parts").string()}, recipe, into(folder / ("out" + std::to_string(jobs)), jobs));
        if (first.empty()) first = textOf(result.results_file);
        EXPECT_EQ(textOf(result.results_file), first) << jobs;
        EXPECT_EQ(result.failed(), 1);
    }
}

TEST(Batch, shards_together_are_the_whole)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 23);
    const std::string parts = (folder / "parts").string();
    const BatchResult whole = runBatch({parts}, recipe, into(folder / "whole"));
    std::vector<std::string> together;
    std::int64_t count = 0;
    for (std::int64_t i = 1; i <= 3; ++i) {
        BatchSettings settings = into(folder / "shards");
        settings.shard = {i, 3};
        const BatchResult part = runBatch({parts}, recipe, settings);
        EXPECT_EQ(std::filesystem::path(part.results_file).filename(),
                  "results-000" + std::to_string(i) + "-of-0003.jsonl");
        count += part.parts;
        for (std::string& line : evaluationsIn(part.results_file)) together.push_back(std::move(line));
    }
    EXPECT_EQ(count, 23);
    EXPECT_THAT(together, UnorderedElementsAreArray(evaluationsIn(whole.results_file)));
    // A whole run over the same folder has nothing left to do.
    const int before = runsCounted();
    EXPECT_EQ(runBatch({parts}, recipe, into(folder / "shards")).taken_over, 23);
    EXPECT_EQ(runsCounted(), before);
}

TEST(Batch, a_second_run_computes_nothing)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 10);
    writeText(folder / "parts" / "p003.txt", "three");  // rejected for its content
    writeText(folder / "parts" / "p004.txt", "-4");     // no answer for its content
    const std::string parts = (folder / "parts").string();
    const BatchResult first = runBatch({parts}, recipe, into(folder / "out", 2));
    const std::string written = textOf(first.results_file), failures = textOf(first.failures_file);
    EXPECT_EQ(first.failed(), 2);
    const int before = runsCounted();
    const BatchResult second = runBatch({parts}, recipe, into(folder / "out", 2));
    EXPECT_EQ(runsCounted(), before);
    EXPECT_EQ(second.computed, 0);
    EXPECT_EQ(second.taken_over, 10);
    EXPECT_EQ(second.verdicts, first.verdicts);
    EXPECT_EQ(textOf(first.results_file), written);
    EXPECT_EQ(textOf(first.failures_file), failures);
    // A further part is computed alone.
    writeText(folder / "parts" / "q.txt", "99");
    EXPECT_EQ(runBatch({parts}, recipe, into(folder / "out")).computed, 1);
    EXPECT_EQ(runsCounted(), before + 1);
}

TEST(Batch, what_may_pass_is_tried_again)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 2);
    writeText(folder / "parts" / "z.txt", "1e9");  // a mistake of the program
    const std::vector<std::string> inputs{(folder / "parts").string(), (folder / "later.txt").string()};
    const BatchResult first = runBatch(inputs, recipe, into(folder / "out"));
    ASSERT_EQ(first.failed(), 2);
    EXPECT_EQ(first.failures[0].code, "internal");
    EXPECT_EQ(first.failures[1].code, "file_not_found");
    EXPECT_EQ(evaluationsIn(first.results_file).size(), 2U);
    writeText(folder / "later.txt", "5");
    const BatchResult second = runBatch(inputs, recipe, into(folder / "out"));
    EXPECT_EQ(second.taken_over, 2);
    EXPECT_EQ(second.computed, 2);
    EXPECT_EQ(second.failed(), 1);
}

TEST(Batch, one_wrong_part_stops_no_other_and_is_listed_for_tables)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 3);
    const std::string odd = (folder / "odd, \"one\".txt").string();
    writeText(odd, "a\"b");
    const BatchResult result = runBatch({odd, (folder / "parts").string()}, recipe, into(folder / "out"));
    EXPECT_EQ(result.verdicts[0], 3);
    ASSERT_EQ(result.failed(), 1);
    EXPECT_EQ(result.failures.front().exit_code, 3);
    EXPECT_EQ(result.failures.front().line, 1);
    const std::vector<std::string> rows = linesOf(textOf(result.failures_file));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_THAT(rows[1], HasSubstr("odd, \"\"one\"\".txt\",3,malformed,1,1,,\""));
    EXPECT_EQ(toJson(result)["failures"][0]["code"], "malformed");
}

TEST(Batch, equal_contents_are_computed_once)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 4);
    writeText(folder / "parts" / "p003.txt", "1");
    const int before = runsCounted();
    const BatchResult result = runBatch({(folder / "parts").string()}, recipe, into(folder / "out", 4));
    EXPECT_EQ(runsCounted(), before + 3);
    EXPECT_EQ(result.duplicates, 1);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(*find(result.notes.front().values, "path"), Value((folder / "parts" / "p003.txt").string()));
    EXPECT_EQ(*find(result.notes.front().values, "other"), Value((folder / "parts" / "p001.txt").string()));
}

TEST(Batch, a_torn_line_is_cut_off)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 12);
    const std::string parts = (folder / "parts").string();
    const std::string results = runBatch({parts}, recipe, into(folder / "out")).results_file;
    const std::string whole = textOf(results);
    const std::size_t lastLine = whole.rfind('\n', whole.size() - 2) + 1;
    for (const std::size_t length : {std::size_t{0}, std::size_t{5}, whole.find('\n'), whole.find('\n') + 1,
                                     lastLine - 1, lastLine + 1, whole.size() - 1}) {
        writeText(results, whole.substr(0, length));
        runBatch({parts}, recipe, into(folder / "out"));
        EXPECT_EQ(textOf(results), whole) << length;
    }
}

TEST(Batch, a_damaged_line_is_named)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 3);
    const std::string parts = (folder / "parts").string();
    const std::string results = runBatch({parts}, recipe, into(folder / "out")).results_file;
    std::string text = textOf(results);
    text.insert(text.find('\n') + 1, "{\"key\": 1}\n");
    writeText(results, text);
    EXPECT_EQ(codeOf([&] { runBatch({parts}, recipe, into(folder / "out")); }), "malformed");
}

TEST(Batch, one_folder_is_for_one_recipe)
{
    const ScratchFolder folder;
    writeParts(folder, 3);
    const std::string parts = (folder / "parts").string();
    runBatch({parts}, numberRecipe(folder), into(folder / "out"));
    const std::string before = textOf(folder / "out" / "results.jsonl");
    EXPECT_EQ(codeOf([&] {
                  runBatch({parts}, numberRecipe(folder, {{"factor", 2.0}}), into(folder / "out"));
              }),
              "batch_other_recipe");
    EXPECT_EQ(textOf(folder / "out" / "results.jsonl"), before);
}

TEST(Batch, a_second_writer_is_refused)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 3);
    const std::string parts = (folder / "parts").string();
    runBatch({parts}, recipe, into(folder / "out"));
    const ResultsFile first((folder / "out" / "results.jsonl").string(), Json::object());
    EXPECT_EQ(codeOf([&] { runBatch({parts}, recipe, into(folder / "out")); }), "batch_under_way");
    BatchSettings other = into(folder / "out");
    other.shard = {2, 3};
    EXPECT_EQ(runBatch({parts}, recipe, other).taken_over, 1);
}

TEST(Batch, cancelling_keeps_what_was_finished)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 40);
    const std::string parts = (folder / "parts").string();
    std::stop_source stop;
    const Progress progress(stop.get_token(), [&](double fraction, Text) {
        if (fraction > 0.5) stop.request_stop();
    });
    EXPECT_THROW(runBatch({parts}, recipe, into(folder / "out", 2), progress), Cancelled);
    const auto kept = static_cast<std::int64_t>(evaluationsIn(folder / "out" / "results.jsonl").size());
    EXPECT_GE(kept, 20);
    EXPECT_LT(kept, 40);
    const BatchResult rest = runBatch({parts}, recipe, into(folder / "out", 2));
    EXPECT_EQ(rest.taken_over, kept);
    EXPECT_EQ(rest.computed, 40 - kept);
    runBatch({parts}, recipe, into(folder / "whole"));
    EXPECT_EQ(evaluationsIn(folder / "out" / "results.jsonl"), evaluationsIn(folder / "whole" / "results.jsonl"));
}

TEST(Batch, an_input_changed_since_the_recipe_is_refused)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 3);
    writeText(folder / "reference.txt", "0.6");
    EXPECT_EQ(codeOf([&] { runBatch({(folder / "parts").string()}, recipe, into(folder / "out")); }),
              "recipe_input_changed");
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(Batch, results_among_the_parts_are_refused)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 3);
    EXPECT_EQ(codeOf([&] { runBatch({(folder / "parts").string()}, recipe, into(folder / "parts")); }),
              "output_is_input");
}

TEST(Batch, each_answered_part_has_a_report_of_its_own)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeText(folder / "a" / "p.txt", "1");
    writeText(folder / "b" / "p.txt", "2");
    writeText(folder / "b" / "q.txt", "two");
    const std::vector<std::string> inputs{(folder / "a").string(), (folder / "b").string()};
    runBatch(inputs, recipe, into(folder / "out"));
    BatchSettings settings = into(folder / "out");
    settings.reports = true;
    const BatchResult result = runBatch(inputs, recipe, settings);  // answered before, without reports
    EXPECT_EQ(result.taken_over, 3);
    EXPECT_THAT(textOf(folder / "out" / "reports" / "p.txt.html"), HasSubstr("value 1.5"));
    EXPECT_THAT(textOf(folder / "out" / "reports" / "p.txt-2.html"), HasSubstr("value 2.5"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out" / "reports" / "q.txt.html"));
    EXPECT_EQ(evaluationsIn(result.results_file).size(), 3U);
}

TEST(Batch, remembers_what_it_was_asked)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder);
    writeParts(folder, 1);
    BatchSettings settings = into(folder / "out");
    settings.asked = {"recipe.json", {(folder / "parts").string()}};
    EXPECT_EQ(codeOf([&] { remembered(settings.folder); }), "batch_not_remembered");
    runBatch(settings.asked.inputs, recipe, settings);
    EXPECT_EQ(remembered(settings.folder).recipe, "recipe.json");
    EXPECT_EQ(remembered(settings.folder).inputs, settings.asked.inputs);
}

}  // namespace
}  // namespace lathelier::batch
