#include "engine/queue/queue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "engine/batch/batch.h"
#include "engine/batch/recipe_file.h"
#include "engine/queue/worker.h"
#include "tests/engine/archive/archive_fixture.h"
#include "tests/engine/batch/number_task.h"
#include "tests/killed_process.h"

namespace lathelier::queue {
namespace {

using archive::Access;
using archive::Archive;

constexpr double soonLost_s = 0.05;

void waitUntilLost()
{
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
}

class Queue : public archive::EitherArchive {
protected:
    void SetUp() override
    {
        location_ = newLocation();
        Archive::open(location_, Access::Create);
    }

    /// Queues the numbers 0…count-1 with one that is none and one without an answer.
    Queued queueNumbers(int count, const Values& parameters = {})
    {
        recipe_ = batch::numberRecipe(scratch_, parameters);
        batch::writeRecipe(recipePath(), recipe_);
        batch::writeParts(scratch_, count);
        Archive archive = Archive::open(location_, Access::Write);
        return enqueue(archive, recipePath(), recipe_, batch::partsOf({partsPath()}, recipe_));
    }

    void addOdd()
    {
        batch::writeText(scratch_ / "parts" / "x1.txt", "many");
        batch::writeText(scratch_ / "parts" / "x2.txt", "-5");
    }

    std::string recipePath() const { return (scratch_ / "recipe.json").string(); }
    std::string partsPath() const { return (scratch_ / "parts").string(); }

    WorkSettings settingsOf(const std::string& worker) const
    {
        WorkSettings settings;
        settings.location = location_;
        settings.worker = worker;
        settings.attestation = archive::inspector;
        settings.lost_after_s = 0.3;
        return settings;
    }

    Worked workAs(const std::string& worker) const { return work(settingsOf(worker), batch::numberTasks(), {}); }

    QueueState state() const
    {
        Archive archive = Archive::open(location_, Access::Read);
        return queue::stateOf(archive);
    }

    /// What the same parts give without a queue.
    std::string canonicalOfBatch()
    {
        const batch::BatchResult result = batch::runBatch({partsPath()}, recipe_, batch::into(scratch_ / "out", 2));
        const std::string other = newLocation();
        Archive archive = Archive::open(other, Access::Create);
        std::vector<archive::Evaluation> all;
        std::string text = batch::textOf(result.results_file);
        for (std::size_t from = 0, end = 0; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
            if (from > 0) all.push_back(archive::evaluationFrom(text.substr(from, end - from)));
        archive.add(all, {});
        return archive::linesOf(archive, true);
    }

    std::string canonical() const { return archive::linesOf(Archive::open(location_, Access::Read), true); }

    std::string location_;
    batch::Recipe recipe_;
};

TEST_P(Queue, computes_every_part_once_and_gives_what_a_batch_gives)
{
    batch::writeParts(scratch_, 1);
    addOdd();
    EXPECT_EQ(queueNumbers(20).queued, 22);
    EXPECT_EQ(queueNumbers(20).already_there, 22);
    const int before = batch::runsCounted();
    const Worked worked = workAs("one");
    EXPECT_EQ(batch::runsCounted() - before, 22);
    EXPECT_EQ(worked.computed, 20);
    EXPECT_EQ(worked.refused, 2);
    const QueueState left = state();
    EXPECT_EQ(left.done, 20);
    EXPECT_EQ(left.failed, 2);
    ASSERT_EQ(left.failures.size(), 2U);
    EXPECT_TRUE(left.failures[0].name.ends_with("x1.txt"));
    EXPECT_NE(left.failures[0].error.find("malformed"), std::string::npos);
    EXPECT_EQ(canonical(), canonicalOfBatch());
    EXPECT_FALSE(Archive::open(location_, Access::Read).verify().broken);
}

TEST_P(Queue, two_workers_share_the_parts)
{
    queueNumbers(30, {{"pause_ms", std::int64_t{5}}});
    const int before = batch::runsCounted();
    Worked first, second;
    {
        const std::jthread one([&] { first = workAs("one"); });
        const std::jthread two([&] { second = workAs("two"); });
    }
    EXPECT_EQ(first.computed + second.computed, 30);
    EXPECT_GT(first.computed, 0);
    EXPECT_GT(second.computed, 0);
    EXPECT_EQ(batch::runsCounted() - before, 30);
    EXPECT_EQ(state().done, 30);
}

TEST_P(Queue, part_of_a_lost_worker_waits_again_three_times)
{
    queueNumbers(1);
    Archive archive = Archive::open(location_, Access::Write);
    for (int i = 1; i <= mostTries; ++i) {
        const auto job = take(archive, "lost", soonLost_s);
        ASSERT_TRUE(job);
        EXPECT_EQ(job->tries, i);
        EXPECT_FALSE(take(archive, "other", 60));  // it is held
        waitUntilLost();
    }
    EXPECT_FALSE(take(archive, "other", soonLost_s));
    const QueueState left = queue::stateOf(archive);
    EXPECT_EQ(left.failed, 1);
    EXPECT_NE(left.failures.at(0).error.find("queue_worker_lost"), std::string::npos);
    EXPECT_NE(left.failures.at(0).error.find("lost"), std::string::npos);
    EXPECT_EQ(retryFailed(archive), 1);
    EXPECT_TRUE(take(archive, "other", 60));
}

TEST_P(Queue, sign_of_life_keeps_a_part_and_a_lost_worker_changes_nothing)
{
    queueNumbers(1);
    Archive archive = Archive::open(location_, Access::Write);
    const auto job = take(archive, "slow", 60);
    waitUntilLost();
    beat(archive, *job, "slow");
    EXPECT_FALSE(take(archive, "other", 0.1));
    waitUntilLost();
    const auto again = take(archive, "other", soonLost_s);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->id, job->id);
    finish(archive, *job, "slow");  // not its part any more
    EXPECT_EQ(queue::stateOf(archive).running, 1);
    finish(archive, *again, "other");
    EXPECT_EQ(queue::stateOf(archive).done, 1);
}

TEST_P(Queue, what_changed_since_is_not_answered)
{
    queueNumbers(2);
    batch::writeText(scratch_ / "parts" / "p000.txt", "77");
    workAs("one");
    QueueState left = state();
    EXPECT_EQ(left.done, 1);
    ASSERT_EQ(left.failures.size(), 1U);
    EXPECT_EQ(left.failures[0].tries, mostTries);
    EXPECT_NE(left.failures[0].error.find("queue_part_changed"), std::string::npos);

    Archive archive = Archive::open(location_, Access::Write);
    retryFailed(archive);
    batch::writeText(scratch_ / "parts" / "p000.txt", "0");
    recipe_.parameters = {{"limit", 3.0}};
    batch::writeRecipe(recipePath(), recipe_);
    workAs("one");
    left = state();
    ASSERT_EQ(left.failures.size(), 1U);
    EXPECT_NE(left.failures[0].error.find("queue_recipe_changed"), std::string::npos);
}

TEST_P(Queue, stopped_worker_gives_its_part_back)
{
    queueNumbers(3, {{"pause_ms", std::int64_t{200}}});
    std::stop_source stop;
    const Progress progress(stop.get_token(), [](double, Text) {});
    const std::jthread stopper([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop.request_stop();
    });
    EXPECT_THROW(work(settingsOf("one"), batch::numberTasks(), {}, progress), Cancelled);
    EXPECT_EQ(state().running, 0);
    EXPECT_EQ(state().waiting + state().done, 3);
    workAs("two");
    EXPECT_EQ(state().done, 3);
}

TEST_P(Queue, killed_workers_lose_and_double_nothing)
{
    constexpr int parts = 60;
    queueNumbers(parts, {{"pause_ms", std::int64_t{4}}});
    std::mt19937 random(20260);
    std::uniform_int_distribution<int> life_ms(30, 150);
    int killed = 0;
    for (int i = 0; i < 5; ++i)
        killed +=
            workAndKill([&] { workAs("killed " + std::to_string(i)); }, std::chrono::milliseconds(life_ms(random)));
    EXPECT_GT(killed, 0);
    workAs("last");
    EXPECT_EQ(state().done, parts);
    const Archive archive = Archive::open(location_, Access::Read);
    archive::Filter all;
    all.most = 0;
    EXPECT_EQ(archive.list(all).size(), static_cast<std::size_t>(parts));
    EXPECT_FALSE(archive.verify().broken);
    EXPECT_EQ(canonical(), canonicalOfBatch());
}

INSTANTIATE_TEST_SUITE_P(Both, Queue, ::testing::Values(archive::Backend::Sqlite, archive::Backend::Postgres),
                         archive::backendName);

}  // namespace
}  // namespace lathelier::queue
