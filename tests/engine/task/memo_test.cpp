#include "engine/task/memo.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "engine/core/error.h"

namespace lathelier {
namespace {

TEST(Memo, ManyAskOneComputes)
{
    Memo<int> memo;
    std::atomic<int> computed{0};
    std::vector<std::thread> threads;
    std::atomic<int> sum{0};
    for (int i = 0; i < 6; ++i)
        threads.emplace_back([&] {
            sum += *memo.find("seven", {}, [&](const Progress&) {
                ++computed;
                std::this_thread::sleep_for(std::chrono::milliseconds(30));
                return 7;
            });
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(computed.load(), 1);
    EXPECT_EQ(sum.load(), 42);
}

TEST(Memo, TheNextTakesOverWhenTheFirstIsStopped)
{
    Memo<int> memo;
    std::stop_source stop;
    std::atomic<bool> begun{false};
    std::thread first([&] {
        try {
            memo.find("key", Progress(stop.get_token(), {}), [&](const Progress& progress) -> int {
                begun = true;
                for (;;) {
                    progress.check();
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
            });
        } catch (const Cancelled&) {
            return;
        }
    });
    while (!begun) std::this_thread::yield();
    int answer = 0;
    std::thread second([&] { answer = *memo.find("key", {}, [](const Progress&) { return 5; }); });
    stop.request_stop();
    first.join();
    second.join();
    EXPECT_EQ(answer, 5);
}

TEST(Memo, AWaiterCanBeStopped)
{
    Memo<int> memo;
    std::atomic<bool> begun{false}, release{false};
    std::thread first([&] {
        memo.find("key", {}, [&](const Progress&) {
            begun = true;
            while (!release) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return 1;
        });
    });
    while (!begun) std::this_thread::yield();
    std::stop_source stop;
    std::atomic<bool> cancelled{false};
    std::thread second([&] {
        try {
            memo.find("key", Progress(stop.get_token(), {}), [](const Progress&) { return 2; });
        } catch (const Cancelled&) {
            cancelled = true;
        }
    });
    stop.request_stop();
    second.join();
    EXPECT_TRUE(cancelled);
    release = true;
    first.join();
}

TEST(Memo, OldAnswersAreForgotten)
{
    Memo<int> memo(2);
    int computed = 0;
    const auto ask = [&](const std::string& key) { memo.find(key, {}, [&](const Progress&) { return ++computed; }); };
    ask("a");
    ask("b");
    ask("a");
    ask("c");  // "b" was used longest ago
    ask("a");
    EXPECT_EQ(computed, 3);
    ask("b");
    EXPECT_EQ(computed, 4);
}

TEST(Memo, WhatFailsIsAskedAgain)
{
    Memo<int> memo;
    EXPECT_THROW(memo.find("key", {}, [](const Progress&) -> int { throw std::bad_alloc(); }), std::bad_alloc);
    EXPECT_EQ(*memo.find("key", {}, [](const Progress&) { return 3; }), 3);
}

}  // namespace
}  // namespace lathelier
