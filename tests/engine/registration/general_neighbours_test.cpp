#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stop_token>

#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/neighbours/cloud_distance.h"
#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/neighbours/neighbours_order.h"
#include "engine/registration/surroundings.h"

namespace lathelier::registration {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// Points of very different density: a cluster, a line, a surface, far outliers and duplicates.
Points unevenPoints(unsigned seed, std::size_t count)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double u = unit(random);
        const double v = unit(random);
        const double w = unit(random);
        switch (i % 5) {
            case 0: points.emplace_back(1e-3 * u, 1e-3 * v, 1e-3 * w); break;
            case 1: points.emplace_back(100 * u, 0, 0); break;
            case 2: points.emplace_back(50 * u, 50 * v, std::sin(u)); break;
            case 3: points.push_back(points[i / 2]); break;
            default: points.emplace_back(1e5 * u, 1e4 * v, w);
        }
    }
    return points;
}

float bruteDistance(const Points& reference, const Eigen::Vector3d& query)
{
    double best = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : reference) {
        const double dx = p.x() - query.x();
        const double dy = p.y() - query.y();
        const double dz = p.z() - query.z();
        best = std::min(best, dx * dx + dy * dy + dz * dz);
    }
    return static_cast<float>(std::sqrt(best));
}

TEST(HilbertOrder, SuccessiveCellsShareAFace)
{
    std::vector<std::array<int, 3>> cell_at(16 * 16 * 16);
    for (std::uint32_t x = 0; x < 16; ++x)
        for (std::uint32_t y = 0; y < 16; ++y)
            for (std::uint32_t z = 0; z < 16; ++z) {
                const std::uint32_t place = hilbertPlace({x << 6, y << 6, z << 6}) >> 18;
                cell_at.at(place) = {static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)};
            }
    for (std::size_t i = 1; i < cell_at.size(); ++i) {
        int steps = 0;
        for (std::size_t a = 0; a < 3; ++a) steps += std::abs(cell_at[i][a] - cell_at[i - 1][a]);
        ASSERT_EQ(steps, 1) << "at place " << i;
    }
}

RC_GTEST_PROP(HilbertOrder, IsAPermutation, ())
{
    const auto count = *rc::gen::inRange<std::size_t>(0, 3000);
    std::vector<std::uint32_t> order = hilbertOrder(unevenPoints(*rc::gen::arbitrary<unsigned>(), count));
    RC_ASSERT(order.size() == count);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < count; ++i) RC_ASSERT(order[i] == i);
}

RC_GTEST_PROP(NearestDistances, EqualsBruteForceExactly, ())
{
    const Points reference = unevenPoints(*rc::gen::arbitrary<unsigned>(), *rc::gen::inRange<std::size_t>(1, 700));
    const Points queries = unevenPoints(*rc::gen::arbitrary<unsigned>(), *rc::gen::inRange<std::size_t>(1, 200));
    const double max_distance = *rc::gen::element(1e-3, 1.0, 1e9);
    const std::vector<float> distances = nearestDistances(reference, queries, max_distance);
    RC_ASSERT(distances.size() == queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const float truth = bruteDistance(reference, queries[i]);
        if (truth > max_distance)
            RC_ASSERT(std::isnan(distances[i]));
        else
            RC_ASSERT(distances[i] == truth);
    }
}

RC_GTEST_PROP(Neighbours, TheNearestSeveralEqualBruteForce, ())
{
    const Points reference = unevenPoints(*rc::gen::arbitrary<unsigned>(), *rc::gen::inRange<std::size_t>(1, 500));
    const Eigen::Vector3d query = unevenPoints(*rc::gen::arbitrary<unsigned>(), 3).back();
    const auto count = *rc::gen::inRange<std::size_t>(0, 30);
    const Neighbours index(reference);
    std::vector<Neighbours::Found> found;
    index.nearest(query, count, 1e12, found);
    std::vector<double> truth;
    for (const Eigen::Vector3d& p : reference) truth.push_back((p - query).squaredNorm());
    std::sort(truth.begin(), truth.end());
    RC_ASSERT(found.size() == std::min(count, reference.size()));
    for (std::size_t i = 0; i < found.size(); ++i) {
        RC_ASSERT(std::abs(found[i].squared_mm2 - truth[i]) <= 1e-12 * truth[i]);
        RC_ASSERT(index.point_mm(found[i].place) == reference[index.input(found[i].place)]);
    }
}

RC_GTEST_PROP(Neighbours, QueriesThatMoveFindTheirNearestAgain, ())
{
    const Points reference = unevenPoints(*rc::gen::arbitrary<unsigned>(), *rc::gen::inRange<std::size_t>(1, 500));
    Points queries = unevenPoints(*rc::gen::arbitrary<unsigned>(), 40);
    const double limit = *rc::gen::element(1e-6, 1.0, 1e12);
    const Neighbours index(reference);
    std::vector<Neighbours::Trace> traces(queries.size());
    std::vector<Neighbours::Found> found(queries.size());
    for (const double step : {0.0, 1e-6, 1e-3, 0.1, 10.0, 1e-3}) {
        for (std::size_t q = 0; q < queries.size(); ++q)
            queries[q] += step * Eigen::Vector3d(1, q % 2 == 0 ? -1 : 2, 0.5);
        index.nearest(queries, limit, traces, found);
        for (std::size_t q = 0; q < queries.size(); ++q) {
            const Neighbours::Found alone = index.nearest(queries[q], limit);
            RC_ASSERT(found[q].squared_mm2 == alone.squared_mm2);
            RC_ASSERT((found[q].place == Neighbours::Found::none) == (alone.place == Neighbours::Found::none));
        }
    }
}

RC_GTEST_PROP(Surroundings, HoldTheNearestPointsWithinReach, ())
{
    const Points reference = unevenPoints(*rc::gen::arbitrary<unsigned>(), *rc::gen::inRange<std::size_t>(1, 500));
    const Neighbours index(reference);
    const auto begin = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(reference.size()));
    const auto end = std::min(begin + 32, static_cast<std::uint32_t>(reference.size()));
    const auto count = *rc::gen::inRange<std::size_t>(1, 30);
    const double reach_mm2 = *rc::gen::element(1e-6, 1.0, 1e4, 1e12);
    Box box;
    for (std::uint32_t i = begin; i < end; ++i) box.add(index.point_mm(i));
    Surroundings surroundings(index);
    surroundings.collect(box, reach_mm2, 100);
    std::vector<Neighbours::Found> found;
    std::vector<Neighbours::Found> truth;
    for (std::uint32_t i = begin; i < end; ++i) {
        index.nearest(index.point_mm(i), count, std::numeric_limits<double>::infinity(), truth);
        const bool within = truth.size() == count && truth.back().squared_mm2 < reach_mm2;
        RC_ASSERT(surroundings.nearest(index.point_mm(i), count, found) == within);
        if (!within) continue;
        RC_ASSERT(
            std::is_sorted(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.place < b.place; }));
        std::vector<double> distances;
        for (const Neighbours::Found& f : found) distances.push_back(f.squared_mm2);
        std::sort(distances.begin(), distances.end());
        RC_ASSERT(distances.size() == count);
        for (std::size_t k = 0; k < count; ++k) RC_ASSERT(distances[k] == truth[k].squared_mm2);
    }
}

TEST(NearestDistances, OfACloudToItselfAreExactlyZero)
{
    const Points points = unevenPoints(7, 50000);
    for (float d : nearestDistances(points, points, 1)) ASSERT_EQ(d, 0.0F);
}

TEST(NearestDistances, AreTheSameForAnyNumberOfThreads)
{
    const Points reference = unevenPoints(1, 100000);
    const Points queries = unevenPoints(2, 100000);
    const std::vector<float> many = nearestDistances(reference, queries, 1e9);
    const ThreadLimit limit(1);
    ASSERT_EQ(threadsAllowed(), 1u);
    EXPECT_EQ(many, nearestDistances(reference, queries, 1e9));
}

TEST(NearestDistances, EmptyInputsGiveNothing)
{
    EXPECT_TRUE(nearestDistances({}, {}, 1).empty());
    EXPECT_TRUE(std::isnan(nearestDistances({}, {{0, 0, 0}}, 1).at(0)));
}

TEST(NearestDistances, AQueryThatIsNotFiniteHasNone)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<float> d = nearestDistances({{1, 2, 3}}, {{notANumber, 0, 0}, {0, infinity, 0}, {1, 2, 4}}, 10);
    EXPECT_TRUE(std::isnan(d[0]));
    EXPECT_TRUE(std::isnan(d[1]));
    EXPECT_EQ(d[2], 1.0F);
}

// Each of these takes minutes where the index degenerates to a brute-force search.
TEST(NearestDistances, NoDistributionIsQuadratic)
{
    const Points queries = unevenPoints(3, 200000);
    Points equal(1000000, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(nearestDistances(equal, queries, 1e300)[2], bruteDistance({{1, 2, 3}}, queries[2]));
    for (std::size_t i = 0; i < equal.size(); ++i) equal[i].x() += 1e-13 * static_cast<double>(i % 7);
    EXPECT_FLOAT_EQ(nearestDistances(equal, queries, 1e300)[2], bruteDistance({{1, 2, 3}}, queries[2]));
    Points far_outliers = unevenPoints(4, 200000);
    far_outliers.emplace_back(1e15, -1e15, 0);
    EXPECT_EQ(nearestDistances(far_outliers, queries, 1e300)[9], bruteDistance(far_outliers, queries[9]));
    Points halving;
    for (int i = 0; i < 200000; ++i) halving.emplace_back(std::ldexp(1.0, -(i % 900)), 0, 0);
    EXPECT_EQ(nearestDistances(halving, queries, 1e300)[9], bruteDistance(halving, queries[9]));
}

TEST(NearestDistances, CanBeCancelled)
{
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(nearestDistances(unevenPoints(1, 1000), unevenPoints(2, 1000), 1, Progress(stop.get_token(), {})),
                 Cancelled);
}

}  // namespace
}  // namespace lathelier::registration
