#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <stop_token>

#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/surface/surface_deviation.h"
#include "engine/sample/sample.h"
#include "tests/engine/registration/cube_mesh.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

struct Moments {
    int count = 0;
    double mean_um = 0;
    double std_um = 0;
};

Moments moments(const std::vector<float>& values_mm)
{
    Moments m;
    double sum = 0;
    double squares = 0;
    for (float v : values_mm)
        if (!std::isnan(v)) {
            ++m.count;
            sum += v;
            squares += double{v} * v;
        }
    m.mean_um = 1000 * sum / m.count;
    m.std_um = std::sqrt(std::max(0.0, 1e6 * squares / m.count - m.mean_um * m.mean_um));
    return m;
}

/// `count` points of a sphere about (7, -3, 2), even by a golden spiral, with noise along the normal.
std::vector<Vector3d> spherePoints(int count, double radius, double sigma, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1);
    std::vector<Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count;
        const double a = i * std::numbers::pi * (3 - std::sqrt(5.0)) + seed;
        const double r = std::sqrt(1 - z * z);
        const double h = radius + (sigma > 0 ? sigma * noise(random) : 0);
        points.emplace_back(Vector3d(7, -3, 2) + h * Vector3d(r * std::cos(a), r * std::sin(a), z));
    }
    return points;
}

double signedBoxDistance(const Vector3d& p, double side)
{
    const Vector3d q = (p - Vector3d::Constant(side / 2)).cwiseAbs() - Vector3d::Constant(side / 2);
    return q.cwiseMax(0).norm() + std::min(0.0, q.maxCoeff());
}

RC_GTEST_PROP(SurfaceDeviation, OfACubeIsItsSignedDistanceInAnyPose, ())
{
    const double side = 10;
    const Scan mesh = cube(side);
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<double> place(-6, 16);
    const Eigen::Isometry3d pose =
        Eigen::Translation3d(place(random), 100 * place(random), place(random)) *
        Eigen::AngleAxisd(place(random), Vector3d(place(random), place(random), place(random)).normalized());
    Scan moved = mesh;
    for (Vector3d& p : moved.points_mm) p = pose * p;
    std::vector<Vector3d> queries;
    std::vector<Vector3d> moved_queries;
    for (int i = 0; i < 300; ++i) {
        queries.emplace_back(place(random), place(random), place(random));
        if (i % 3 == 0) queries.back().x() = queries.back().y();  // beside edges and corners too
        moved_queries.push_back(pose * queries.back());
    }
    const SurfaceDeviation still = surfaceDeviation(mesh, queries, 100);
    const SurfaceDeviation there = surfaceDeviation(moved, moved_queries, 100);
    RC_ASSERT(still.has_sign && there.has_sign);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        RC_ASSERT(std::abs(still.deviation_mm[i] - signedBoxDistance(queries[i], side)) < 1e-6);
        RC_ASSERT(std::abs(there.deviation_mm[i] - signedBoxDistance(queries[i], side)) < 1e-5);
    }
}

TEST(SurfaceDeviation, OfAnInsideOutMeshHasTheSameSign)
{
    Scan mesh = cube(10);
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
    const SurfaceDeviation d = surfaceDeviation(mesh, {{5, 5, 12}, {5, 5, 9}}, 100);
    EXPECT_TRUE(d.has_sign);
    EXPECT_FLOAT_EQ(d.deviation_mm[0], 2);
    EXPECT_FLOAT_EQ(d.deviation_mm[1], -1);
}

TEST(SurfaceDeviation, OfAMeshWithOneFacetMissingIsThatOfTheWholeOne)
{
    Scan mesh = cube(10);
    mesh.triangles.pop_back();
    const SurfaceDeviation d = surfaceDeviation(mesh, {{5, 5, 12}, {5, 5, 9}, {11, 8, 8}, {9.5, 8, 7}}, 100);
    EXPECT_TRUE(d.has_sign);
    EXPECT_TRUE(contains(d.notes, notes::holesFilled));
    EXPECT_FLOAT_EQ(d.deviation_mm[0], 2);
    EXPECT_FLOAT_EQ(d.deviation_mm[1], -1);
    EXPECT_FLOAT_EQ(d.deviation_mm[2], 1);
    EXPECT_FLOAT_EQ(d.deviation_mm[3], -0.5);
}

TEST(SurfaceDeviation, OfAMeshWithoutSharedVerticesHasASign)
{
    const Scan shared = cube(10);
    Scan soup;
    for (const auto& t : shared.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.points_mm.size());
        for (std::uint32_t v : t) soup.points_mm.push_back(shared.points_mm[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const SurfaceDeviation d = surfaceDeviation(soup, {{12, 12, 12}, {9, 5, 5}}, 100);
    EXPECT_TRUE(d.has_sign);
    EXPECT_FLOAT_EQ(d.deviation_mm[0], static_cast<float>(2 * std::sqrt(3.0)));
    EXPECT_FLOAT_EQ(d.deviation_mm[1], -1);
}

TEST(SurfaceDeviation, FarPointsAndPointsThatAreNotFiniteHaveNone)
{
    const SurfaceDeviation d = surfaceDeviation(cube(10), {{5, 5, 11}, {5, 5, 11.01}, {notANumber, 0, 0}}, 1);
    EXPECT_FLOAT_EQ(d.deviation_mm[0], 1);
    EXPECT_TRUE(std::isnan(d.deviation_mm[1]));
    EXPECT_TRUE(std::isnan(d.deviation_mm[2]));
}

TEST(SurfaceDeviation, OfACloudWithoutNoiseIsTheDistanceToItsSurface)
{
    Scan reference;
    reference.points_mm = spherePoints(40000, 20, 0, 1);
    for (double excess : {-0.4, -0.05, 0.0, 0.05, 0.4}) {
        const SurfaceDeviation d = surfaceDeviation(reference, spherePoints(3000, 20 + excess, 0, 2), 1);
        EXPECT_TRUE(d.has_sign);
        const Moments m = moments(d.deviation_mm);
        EXPECT_EQ(m.count, 3000);
        EXPECT_NEAR(m.mean_um, 1000 * excess, 0.1);
        EXPECT_LT(m.std_um, 0.5);
    }
}

TEST(SurfaceDeviation, OfANoisyCloudReadsAnExcessOf50AsFifty)
{
    Scan reference;
    reference.points_mm = spherePoints(80000, 20, 0.05, 1);
    const Moments m = moments(surfaceDeviation(reference, spherePoints(60000, 20.05, 0.05, 2), 1).deviation_mm);
    EXPECT_NEAR(m.mean_um, 50, 0.5);
    EXPECT_NEAR(m.std_um, 50, 2.5);
}

TEST(SurfaceDeviation, OfACloudFromItselfIsItsOwnScatterAboutZero)
{
    const Scan bracket = sample::scanBracket(200000, 0.05, Eigen::Isometry3d::Identity(), 1);
    const SurfaceDeviation d = surfaceDeviation(bracket, bracket.points_mm, 1);
    const Moments m = moments(d.deviation_mm);
    EXPECT_TRUE(d.has_sign);
    EXPECT_GT(m.count, 199900);
    EXPECT_NEAR(m.mean_um, 0, 0.3);  // sharp edges at 2 points a mm²
    EXPECT_NEAR(m.std_um, 50, 5);
}

TEST(SurfaceDeviation, OfAPlainPatchHasNoSign)
{
    Scan plate;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 50);
    for (int i = 0; i < 20000; ++i) plate.points_mm.emplace_back(place(random), place(random), 0);
    const SurfaceDeviation d = surfaceDeviation(plate, {{25, 25, 0.5}, {25, 25, -0.5}, {60, 25, 0}}, 20);
    EXPECT_FALSE(d.has_sign);
    EXPECT_TRUE(contains(d.notes, notes::signUndetermined));
    EXPECT_NEAR(d.deviation_mm[0], 0.5, 1e-6);
    EXPECT_NEAR(d.deviation_mm[1], 0.5, 1e-6);
    EXPECT_TRUE(std::isnan(d.deviation_mm[2])) << "beside the plate there is no surface";
}

TEST(SurfaceDeviation, TakesTheSignFromNormals)
{
    Scan plate;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 50);
    for (int i = 0; i < 20000; ++i) plate.points_mm.emplace_back(place(random), place(random), 0);
    plate.normals.assign(plate.points_mm.size(), {0, 0, -1});
    const SurfaceDeviation d = surfaceDeviation(plate, {{25, 25, 0.5}, {25, 25, -0.5}}, 20);
    EXPECT_TRUE(d.has_sign);
    EXPECT_NEAR(d.deviation_mm[0], -0.5, 1e-6);
    EXPECT_NEAR(d.deviation_mm[1], 0.5, 1e-6);
}

TEST(SurfaceDeviation, IsTheSameForAnyNumberOfThreads)
{
    const Scan bracket = sample::scanBracket(20000, 0.05, Eigen::Isometry3d::Identity(), 1);
    const Scan copy = sample::scanBracket(20000, 0.05, Eigen::Isometry3d::Identity(), 2);
    const auto bits = [](const std::vector<float>& values) {
        std::vector<std::uint32_t> result;
        for (float v : values) result.push_back(std::bit_cast<std::uint32_t>(v));
        return result;
    };
    const auto many = bits(surfaceDeviation(bracket, copy.points_mm, 1).deviation_mm);
    const auto many_mesh = bits(surfaceDeviation(sample::bracketMesh(), copy.points_mm, 1).deviation_mm);
    const ThreadLimit limit(1);
    ASSERT_EQ(threadsAllowed(), 1u);
    EXPECT_EQ(many, bits(surfaceDeviation(bracket, copy.points_mm, 1).deviation_mm));
    EXPECT_EQ(many_mesh, bits(surfaceDeviation(sample::bracketMesh(), copy.points_mm, 1).deviation_mm));
}

TEST(SurfaceDeviation, SurvivesDegenerateReferences)
{
    std::vector<Vector3d> line;
    for (int i = 0; i < 1000; ++i) line.emplace_back(i, 0, 0);
    for (const auto& points : {std::vector<Vector3d>(100000, Vector3d(1, 2, 3)), line,
                               std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}) {
        Scan reference;
        reference.points_mm = points;
        EXPECT_EQ(surfaceDeviation(reference, line, 10).deviation_mm.size(), line.size());
    }
    EXPECT_THROW(surfaceDeviation({{{0, 0, 0}}, {}, {}}, line, 10), Error);
    EXPECT_TRUE(surfaceDeviation(cube(1), {}, 10).deviation_mm.empty());
}

TEST(SurfaceDeviation, CanBeCancelled)
{
    std::stop_source stop;
    stop.request_stop();
    const Scan bracket = sample::scanBracket(20000, 0.05, Eigen::Isometry3d::Identity(), 1);
    EXPECT_THROW(surfaceDeviation(bracket, bracket.points_mm, 1, Progress(stop.get_token(), {})), Cancelled);
}

}  // namespace
}  // namespace lathelier::registration
