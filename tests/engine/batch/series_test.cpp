#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/archive/evaluation.h"
#include "engine/batch/recipe_file.h"
#include "engine/cad/task/compare_task.h"
#include "engine/sample/series_sample.h"
#include "engine/trajectory/task/roundness_task.h"
#include "tests/engine/batch/number_task.h"

namespace lathelier::batch {
namespace {

Tasks realTasks()
{
    return {&cad::compareTask(), &trajectory::roundnessTask()};
}

TEST(Series, of_sixty_parts_exactly_the_three_bad_ones_are_found)
{
    const ScratchFolder folder;
    sample::SeriesModel model;
    model.parts = 60;
    sample::writeSeries(folder.string(), model);
    const Recipe recipe = loadRecipe((folder / "recipe.json").string(), realTasks()).recipe;
    const BatchResult result = runBatch({(folder / "parts").string()}, recipe, into(folder / "out", 2));
    EXPECT_EQ(result.verdicts, (std::array<std::int64_t, 4>{57, 3, 0, 0}));
    std::ifstream lines(result.results_file);
    std::string line;
    std::getline(lines, line);
    std::vector<int> bad;
    for (int number = 0; std::getline(lines, line); ++number) {
        const archive::Evaluation one = archive::evaluationFrom(line);
        if (one.verdict == Verdict::Fail) bad.push_back(number);
        for (const task::Characteristic& value : one.characteristics)
            if (value.key == "zones.seat.mean_mm") {
                EXPECT_NEAR(value.value, oversize_um(model, number) / 1000, 0.004) << number;
            }
    }
    EXPECT_EQ(bad, badParts(model));
}

TEST(Series, evaluations_of_a_real_task_do_not_depend_on_jobs)
{
    const ScratchFolder folder;
    sample::SeriesModel model;
    model.parts = 8;
    model.points = 3000;
    sample::writeSeries(folder.string(), model);
    const Recipe recipe = loadRecipe((folder / "recipe.json").string(), realTasks()).recipe;
    const BatchResult one = runBatch({(folder / "parts").string()}, recipe, into(folder / "one", 1));
    const BatchResult four = runBatch({(folder / "parts").string()}, recipe, into(folder / "four", 4));
    EXPECT_EQ(textOf(one.results_file), textOf(four.results_file));
    const archive::Evaluation last = [&] {
        const std::string text = textOf(one.results_file);
        return archive::evaluationFrom(std::string_view(text).substr(text.rfind('\n', text.size() - 2) + 1));
    }();
    EXPECT_EQ(Json::parse(last.result)["command"], "compare");
}

}  // namespace
}  // namespace lathelier::batch
