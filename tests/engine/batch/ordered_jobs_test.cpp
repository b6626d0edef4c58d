#include "engine/batch/ordered_jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>

namespace lathelier::batch {
namespace {

constexpr std::size_t count = 500;

std::vector<std::size_t> firstPlaces(std::size_t number)
{
    std::vector<std::size_t> places(number);
    std::iota(places.begin(), places.end(), std::size_t{0});
    return places;
}

TEST(OrderedJobs, results_leave_and_decide_in_order)
{
    OrderedJobs<std::size_t> jobs(count, 4);
    std::vector<std::size_t> decided, left;
    jobs.run(
        4, onThreads,
        [&](std::size_t place) {
            jobs.turn(place, [&] { decided.push_back(place); });
            return 3 * place;
        },
        [&](std::size_t place, std::size_t& result) {
            EXPECT_EQ(result, 3 * place);
            left.push_back(place);
        });
    EXPECT_EQ(decided, firstPlaces(count));
    EXPECT_EQ(left, firstPlaces(count));
}

TEST(OrderedJobs, few_results_wait_for_the_one_before_them)
{
    OrderedJobs<int> jobs(count, 2);
    std::atomic<std::size_t> left{0};
    jobs.run(
        2, onThreads,
        [&](std::size_t place) {
            EXPECT_LT(place, left + 17);  // 8 for each job
            return 0;
        },
        [&](std::size_t, int&) { ++left; });
    EXPECT_EQ(left, count);
}

TEST(OrderedJobs, the_first_exception_ends_all_jobs)
{
    for (const std::size_t failing : {std::size_t{0}, std::size_t{123}, count - 1}) {
        OrderedJobs<int> jobs(count, 4);
        std::vector<std::size_t> left;
        const auto run = [&] {
            jobs.run(
                4, onThreads,
                [&](std::size_t place) {
                    if (place == failing) throw std::runtime_error("failed");
                    jobs.turn(place, [] {});
                    return 0;
                },
                [&](std::size_t place, int&) { left.push_back(place); });
        };
        EXPECT_THROW(run(), std::runtime_error);
        EXPECT_LE(left.size(), failing);
        EXPECT_EQ(left, firstPlaces(left.size()));
    }
}

}  // namespace
}  // namespace lathelier::batch
