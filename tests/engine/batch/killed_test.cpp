#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "tests/engine/batch/number_task.h"

namespace lathelier::batch {
namespace {

/// Runs the batch in a process of its own, which is killed after `life`; whether it ended by itself.
bool runAndKill(const std::string& parts, const Recipe& recipe, const BatchSettings& settings,
                std::chrono::milliseconds life)
{
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            runBatch({parts}, recipe, settings);
        } catch (...) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    std::this_thread::sleep_for(life);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status);
}

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
        if (!runAndKill(parts, recipe, settings, std::chrono::milliseconds(life_ms(random)))) ++killed;
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
