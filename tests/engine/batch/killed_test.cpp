#include <gtest/gtest.h>
#include <chrono>
#include <random>

#include "tests/engine/batch/number_task.h"
#include "tests/killed_process.h"

namespace lathelier::batch {
namespace {

TEST(KilledBatch, is_continued_without_loss_or_repetition)
{
    const ScratchFolder folder;
    const Recipe recipe = numberRecipe(folder, {{"pause_ms", std::int64_t{4}}});
    writeParts(folder, 250);
    writeText(folder / "parts" / "p100.txt", "a hundred");
    const std::string parts = (folder / "parts").string();
    const BatchSettings settings = into(folder / "out", 2);
    std::mt19937 random(20260);
    std::uniform_int_distribution<int> life_ms(20, 120);
    int killed = 0;
    for (int i = 0; i < 5; ++i)
        killed += workAndKill([&] { runBatch({parts}, recipe, settings); }, std::chrono::milliseconds(life_ms(random)));
    EXPECT_GT(killed, 0);
    const BatchResult rest = runBatch({parts}, recipe, settings);
    EXPECT_EQ(rest.parts, 250);
    EXPECT_EQ(rest.computed + rest.taken_over, 250);
    const BatchResult whole = runBatch({parts}, recipe, into(folder / "whole", 2));
    EXPECT_EQ(textOf(rest.results_file), textOf(whole.results_file));
    EXPECT_EQ(textOf(rest.failures_file), textOf(whole.failures_file));
}

}  // namespace
}  // namespace lathelier::batch
