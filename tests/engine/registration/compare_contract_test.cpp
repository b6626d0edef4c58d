// compare(): errors, cancellation, and its JSON.
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/registration/compare.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/registration_codes.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/registration/synthetic_pair.h"

namespace lathelier::registration {
namespace {

using namespace testing_pair;
using Eigen::Vector3d;

TEST(Compare, RefusesPartsThatDoNotMatch)
{
    sample::ShaftModel other{{.z_start_mm = 0, .z_end_mm = 60, .radius_start_mm = 30, .radius_end_mm = 30},
                             {.z_start_mm = 60, .z_end_mm = 150, .radius_start_mm = 22, .radius_end_mm = 22}};
    const Pair pair = makePair(12, {.copy = other});
    try {
        compare(pair.reference, pair.copy);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::partsDoNotMatch);
        EXPECT_NE(find(error.values(), "overlap_percent"), nullptr);
    }
}

TEST(Compare, RefusesHostileClouds)
{
    const Scan good = makePair(1, {.angle_step_deg = 9}).reference;
    const auto cloud = [](std::size_t count, const std::function<Vector3d(double, double, double)>& place) {
        Scan scan;
        for (std::size_t i = 0; i < count; ++i)
            scan.points_mm.push_back(place(randomUniform(1, 0, i), randomUniform(1, 1, i), randomUniform(1, 2, i)));
        return scan;
    };
    const std::vector<std::pair<Scan, ErrorCode>> hostile{
        {Scan{}, errors::tooFewPoints},
        {cloud(2, [](double x, double y, double z) { return Vector3d(x, y, z); }), errors::tooFewPoints},
        {cloud(4, [](double x, double y, double z) { return Vector3d(x, y, z); }), errors::tooFewPoints},
        {cloud(1000, [](double, double, double) { return Vector3d(3, 4, 5); }), errors::pointsDegenerate},
        {cloud(1000, [](double x, double, double) { return Vector3d(3 * x, 4 * x, 50 * x); }),
         errors::pointsDegenerate},
        {cloud(1000, [](double x, double y, double) { return Vector3d(30 * x, 4 * y, 50 * x + y); }),
         errors::pointsDegenerate},
        {cloud(1000, [](double x, double y, double z) { return Vector3d(1e9 + x, y, z); }), errors::coordinateTooLarge},
        {cloud(1000, [](double x, double y, double z) { return Vector3d(1e30 * x, 1e30 * y, z); }),
         errors::coordinateTooLarge},
        {cloud(1000, [](double x, double y, double z) { return Vector3d(1e300 * x, -1e300 * y, z); }),
         errors::coordinateTooLarge},
        {cloud(1000, [&](double x, double y, double z) { return Vector3d(x > 0.9 ? notANumber : x, y, z); }),
         errors::coordinateTooLarge},
    };
    for (std::size_t k = 0; k < hostile.size(); ++k)
        for (const bool first : {true, false}) {
            const auto run = [&] { first ? compare(hostile[k].first, good) : compare(good, hostile[k].first); };
            EXPECT_EQ(codeOfError(run), hostile[k].second) << "cloud " << k;
        }
    // Noise in a box, few points, a mesh of one triangle: an error of some kind, never a number that looks right.
    for (const std::size_t count : {50u, 3000u}) {
        const Scan box = cloud(count, [](double x, double y, double z) { return Vector3d(300 * x, 200 * y, 250 * z); });
        EXPECT_THROW(compare(good, box), Error) << count;
        EXPECT_THROW(compare(box, good), Error) << count;
    }
    Scan triangle;
    triangle.points_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.triangles = {{0, 1, 2}};
    EXPECT_THROW(compare(triangle, good), Error);
    triangle.points_mm.assign(3, Vector3d(1, 1, 1));
    EXPECT_THROW(compare(good, triangle), Error);
}

TEST(Compare, StopsWhenAsked)
{
    const Pair pair = makePair(14);
    std::atomic<int> all = 0;
    compare(pair.reference, pair.copy, {}, Progress({}, [&](double fraction, Text) {
                EXPECT_GE(fraction, 0);
                EXPECT_LE(fraction, 1);
                ++all;
            }));
    EXPECT_GT(all, 8);
    for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        std::stop_source stop;
        std::atomic<int> reports = 0;
        const Progress progress(stop.get_token(), [&](double, Text) {
            if (++reports > share * all) stop.request_stop();
        });
        if (share == 0) stop.request_stop();
        EXPECT_THROW(compare(pair.reference, pair.copy, {}, progress), Cancelled) << share;
    }
}

TEST(Compare, ChecksItsParameters)
{
    const Pair pair = makePair(1, {.angle_step_deg = 9});
    CompareParameters parameters;
    parameters.tolerance_mm = -1;
    EXPECT_EQ(codeOfError([&] { compare(pair.reference, pair.copy, parameters); }), errors::valueOutOfRange);
    parameters.tolerance_mm = 0.1;
    const CompareParameters back = fromValues<CompareParameters>(toValues(parameters));
    EXPECT_EQ(back.tolerance_mm, 0.1);
    EXPECT_FALSE(back.max_distance_mm);
}

TEST(Compare, JsonHasThePromisedKeys)
{
    const Pair pair = makePair(15, {.angle_step_deg = 9});
    const Json json = toJson(compare(pair.reference, pair.copy));
    for (const char* key : {"transform_reference_from_copy",
                            "converged",
                            "iterations",
                            "overlap_percent",
                            "points_used",
                            "points_excluded",
                            "rmse_mm",
                            "mean_mm",
                            "std_mm",
                            "min_mm",
                            "max_mm",
                            "p95_abs_mm",
                            "within_tolerance_percent",
                            "scatter_mm",
                            "verdict_rule",
                            "decision_rule",
                            "verdict",
                            "worst",
                            "findings",
                            "distinguishable_from_scanner",
                            "cloud_to_cloud_rmse_mm",
                            "cloud_to_cloud_rmse_standard_error_mm",
                            "sampling_floor_mm",
                            "axis",
                            "zones",
                            "free_motions",
                            "uncertainty",
                            "histogram"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["transform_reference_from_copy"].size(), 16u);
    EXPECT_EQ(json["transform_reference_from_copy"][15], 1.0);
    EXPECT_TRUE(json["verdict"].is_null());
    EXPECT_TRUE(json["within_tolerance_percent"].is_null());
    EXPECT_EQ(json["free_motions"][0]["kind"], "rotation");
    EXPECT_EQ(json["axis"]["direction"].size(), 3u);
    EXPECT_EQ(json["histogram"]["edges_mm"].size(), json["histogram"]["counts"].size() + 1);
    for (const char* key : {"axial_um", "radial_um", "axis_deg"}) EXPECT_TRUE(json["uncertainty"][key].is_number());
    CompareResult none;
    none.has_sign = false;
    EXPECT_TRUE(toJson(none)["mean_mm"].is_null());
    EXPECT_TRUE(toJson(none)["cloud_to_cloud_rmse_mm"].is_null());
    EXPECT_TRUE(toJson(none)["axis"].is_null());
}

}  // namespace
}  // namespace lathelier::registration
