// The latest-job-wins worker, without Qt: run under ThreadSanitizer too (./dev test).
#include "widgets/core/task/worker.h"
#include "engine/core/core_codes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace lathelier {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const void> boxed(int value)
{
    return std::make_shared<const int>(value);
}

/// Waits for the outcome of the newest request.
Worker::Outcome await(Worker& worker)
{
    while (true) {
        if (auto outcome = worker.take()) return *outcome;
        std::this_thread::sleep_for(1ms);
    }
}

int number(const Worker::Outcome& outcome)
{
    return *std::static_pointer_cast<const int>(std::get<std::shared_ptr<const void>>(outcome));
}

/// A job that runs until it is stopped, as a long loop of the engine does.
Worker::Job endless(std::atomic<int>& begun, std::atomic<int>& stopped)
{
    return [&](const Progress& progress) -> std::shared_ptr<const void> {
        ++begun;
        try {
            while (true) {
                progress.report(0.5);
                std::this_thread::sleep_for(1ms);
            }
        } catch (const Cancelled&) {
            ++stopped;
            throw;
        }
    };
}

void awaitCount(const std::atomic<int>& count, int wanted)
{
    while (count < wanted) std::this_thread::sleep_for(1ms);
}

TEST(Worker, DeliversTheValueOnce)
{
    Worker worker;
    EXPECT_FALSE(worker.state().busy);
    worker.request([](const Progress&) { return boxed(7); });
    EXPECT_EQ(number(await(worker)), 7);
    EXPECT_FALSE(worker.take().has_value());
    EXPECT_FALSE(worker.state().busy);
}

TEST(Worker, WhatWasNotTakenIsCancelledToo)
{
    Worker worker;
    worker.request([](const Progress&) { return boxed(7); });
    while (worker.state().busy) std::this_thread::sleep_for(1ms);
    worker.cancel();
    EXPECT_TRUE(std::holds_alternative<Cancelled>(*worker.take()));
    worker.cancel();
    EXPECT_FALSE(worker.take().has_value());
}

TEST(Worker, LatestWinsAndTheRunningOneIsStopped)
{
    std::atomic<int> begun = 0;
    std::atomic<int> stopped = 0;
    Worker worker;
    worker.request(endless(begun, stopped));
    awaitCount(begun, 1);
    worker.request([](const Progress&) { return boxed(2); });
    EXPECT_EQ(number(await(worker)), 2);
    EXPECT_EQ(stopped, 1);
}

TEST(Worker, WaitingRequestsThatBecameStaleAreNeverComputed)
{
    std::atomic<bool> leave = false;
    std::atomic<int> begun = 0;
    std::atomic<int> stale = 0;
    Worker worker;
    worker.request([&](const Progress&) {
        ++begun;
        while (!leave) std::this_thread::sleep_for(1ms);
        return boxed(-1);
    });
    awaitCount(begun, 1);
    for (int i = 0; i < 100; ++i)
        worker.request([&stale, i](const Progress&) {
            if (i < 99) ++stale;
            return boxed(i);
        });
    leave = true;
    EXPECT_EQ(number(await(worker)), 99);
    EXPECT_EQ(stale, 0);
}

TEST(Worker, AnAnswerOfAnOlderRequestIsNotDelivered)
{
    std::atomic<bool> leave = false;
    std::atomic<int> begun = 0;
    Worker worker;
    worker.request([&](const Progress&) {  // does not look at its progress
        ++begun;
        while (!leave) std::this_thread::sleep_for(1ms);
        return boxed(1);
    });
    awaitCount(begun, 1);
    worker.request([](const Progress&) { return boxed(2); });
    leave = true;
    EXPECT_EQ(number(await(worker)), 2);
    std::this_thread::sleep_for(10ms);
    EXPECT_FALSE(worker.take().has_value());
}

TEST(Worker, CancelStopsTheRunningJob)
{
    std::atomic<int> begun = 0;
    std::atomic<int> stopped = 0;
    Worker worker;
    worker.request(endless(begun, stopped));
    awaitCount(begun, 1);
    worker.cancel();
    EXPECT_TRUE(std::holds_alternative<Cancelled>(await(worker)));
    EXPECT_EQ(stopped, 1);
    EXPECT_FALSE(worker.state().busy);
    worker.request([](const Progress&) { return boxed(3); });
    EXPECT_EQ(number(await(worker)), 3);
}

TEST(Worker, CancelOfAWaitingJobAnswersAtOnce)
{
    std::atomic<bool> leave = false;
    std::atomic<int> begun = 0;
    std::atomic<int> computed = 0;
    Worker worker;
    worker.request([&](const Progress&) {
        ++begun;
        while (!leave) std::this_thread::sleep_for(1ms);
        return boxed(1);
    });
    awaitCount(begun, 1);
    worker.request([&](const Progress&) {
        ++computed;
        return boxed(2);
    });
    worker.cancel();
    const auto outcome = worker.take();
    ASSERT_TRUE(outcome.has_value());
    EXPECT_TRUE(std::holds_alternative<Cancelled>(*outcome));
    leave = true;
    worker.request([](const Progress&) { return boxed(3); });
    EXPECT_EQ(number(await(worker)), 3);
    EXPECT_EQ(computed, 0);
}

TEST(Worker, CancelWhenIdleDoesNothing)
{
    Worker worker;
    worker.cancel();
    EXPECT_FALSE(worker.take().has_value());
}

TEST(Worker, ErrorsComeThroughAsData)
{
    Worker worker;
    worker.request([](const Progress&) -> std::shared_ptr<const void> {
        throw Error(errors::tooFewPoints, {{"found", std::int64_t{4}}});
    });
    const auto outcome = await(worker);
    ASSERT_TRUE(std::holds_alternative<Error>(outcome));
    EXPECT_EQ(std::get<Error>(outcome).code(), errors::tooFewPoints);
}

TEST(Worker, ForeignExceptionsBecomeErrors)
{
    Worker worker;
    worker.request([](const Progress&) -> std::shared_ptr<const void> { throw std::bad_alloc(); });
    EXPECT_EQ(std::get<Error>(await(worker)).code(), errors::outOfMemory);
    worker.request([](const Progress&) -> std::shared_ptr<const void> { throw std::runtime_error("x"); });
    EXPECT_EQ(std::get<Error>(await(worker)).code(), errors::internal);
}

TEST(Worker, ProgressIsReadableAndNeverFalls)
{
    std::atomic<int> step = 0;
    Worker worker;
    worker.request([&](const Progress& progress) {
        const Progress part = progress.part(0, 1, Text{"Reading"});
        part.report(0.6);
        part.report(0.2);  // chunks of a parallel loop report out of order
        step = 1;
        while (step < 2) std::this_thread::sleep_for(1ms);
        return boxed(1);
    });
    awaitCount(step, 1);
    const Worker::State state = worker.state();
    EXPECT_TRUE(state.busy);
    EXPECT_DOUBLE_EQ(state.fraction, 0.6);
    EXPECT_EQ(state.stage, Text{"Reading"});
    step = 2;
    await(worker);
    EXPECT_EQ(worker.state().fraction, 0);
}

TEST(Worker, DestructionStopsTheRunningJob)
{
    std::atomic<int> begun = 0;
    std::atomic<int> stopped = 0;
    {
        Worker worker;
        worker.request(endless(begun, stopped));
        awaitCount(begun, 1);
    }
    EXPECT_EQ(stopped, 1);
}

TEST(Worker, SurvivesManyThreadsAtOnce)
{
    Worker worker;
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&worker, t] {
                for (int i = 0; i < 50; ++i) {
                    worker.request([](const Progress& progress) {
                        for (int k = 0; k < 10; ++k) progress.report(k / 10.0);
                        return boxed(0);
                    });
                    if (i % 7 == t) worker.cancel();
                    worker.state();
                    worker.take();
                }
            });
    }
    worker.request([](const Progress&) { return boxed(42); });
    EXPECT_EQ(number(await(worker)), 42);
}

}  // namespace
}  // namespace lathelier
