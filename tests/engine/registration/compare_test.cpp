#include "engine/registration/compare.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/io/file.h"
#include "engine/io/scan_reader.h"
#include "engine/registration/compare_json.h"
#include "tests/engine/registration/synthetic_pair.h"

namespace lathelier {
namespace {

using namespace testing_pair;
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Mean deviation of the used points between two heights of the part.
double meanBetween(const CompareResult& result, const Pair& pair, double from_mm, double to_mm)
{
    const Isometry3d part_T_copy = pair.copy_T_part.inverse();
    double sum = 0;
    double n = 0;
    for (std::size_t i = 0; i < pair.copy.points_mm.size(); ++i) {
        const double z = (part_T_copy * pair.copy.points_mm[i]).z();
        if (!result.used[i] || z < from_mm || z > to_mm) continue;
        sum += result.deviation_mm[i];
        n += 1;
    }
    return sum / n;
}

/// Mean of the error put into the copy between two heights, without what lies beside edges.
double truthBetween(double from_mm, double to_mm)
{
    double sum = 0;
    constexpr int kSteps = 1000;
    for (int k = 0; k < kSteps; ++k) {
        const double z = from_mm + (to_mm - from_mm) * (k + 0.5) / kSteps;
        sum += radius_mm(copiedShaft(), z) - radius_mm(nominalShaft(), z);
    }
    return sum / kSteps;
}

Isometry3d motion(double angle, double shift)
{
    return Eigen::Translation3d(shift, -shift, shift / 2) * Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized());
}

Scan movedBy(const Isometry3d& pose, Scan scan)
{
    for (Vector3d& p : scan.points_mm) p = pose * p;
    for (Eigen::Vector3f& n : scan.normals) n = pose.linear().cast<float>() * n;
    return scan;
}

template <class Run>
ErrorCode errorOfRun(const Run& run)
{
    try {
        run();
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return ErrorCode::Internal;
}

TEST(Compare, ReadsTheErrorsPutIntoTheCopy)
{
    const Pair pair = makePair(4, {.copy = copiedShaft(), .angle_step_deg = 0.9});
    const CompareResult result = compare(pair.reference, pair.copy);
    EXPECT_EQ(result.method_used, CompareMethod::Revolution);
    for (const auto& [from, to] :
         {std::pair{0.5, 5.5}, {92.5, 97.5}, {98.5, 107.5}, {140.0, 146.0}, {108.5, 114.0}, {46.0, 52.0}})
        EXPECT_NEAR(meanBetween(result, pair, from, to), truthBetween(from, to), 0.002) << from << "…" << to;
    EXPECT_NEAR(meanBetween(result, pair, 98.5, 107.5), 0.050, 0.002);
    EXPECT_NEAR(meanBetween(result, pair, 140, 146), 0.040, 0.002);
    EXPECT_NEAR(meanBetween(result, pair, 178.5, 182.5), 0, 0.002);
    EXPECT_GT(result.statistics.overlap_percent, 99.9);
    EXPECT_GT(result.statistics.min_mm, -0.5);  // sane beside the edges as well
    EXPECT_LT(result.statistics.max_mm, 0.5);

    // A reader of the zones sees the collar.
    const auto collar = std::find_if(result.zones.begin(), result.zones.end(),
                                     [](const Zone& z) { return z.z_start_mm > 97.9 && z.z_end_mm < 108.1; });
    ASSERT_NE(collar, result.zones.end());
    EXPECT_NEAR(collar->mean_mm, 0.050, 0.002);
    EXPECT_GT(collar->z_end_mm - collar->z_start_mm, 8);
    EXPECT_NEAR(collar->std_mm, 0.05, 0.002);
    EXPECT_NEAR(result.sampling_floor_mm, 0.078, 0.004);
    EXPECT_NEAR(result.cloud_to_cloud_rmse_mm, 0.100, 0.004);
}

TEST(Compare, WithItselfIsTheIdentity)
{
    const Pair pair = makePair(2);
    const CompareResult result = compare(pair.reference, pair.reference);
    EXPECT_LT((result.alignment.reference_T_copy.matrix() - Eigen::Matrix4d::Identity()).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_NEAR(result.statistics.mean_mm, 0, 1e-4);
    EXPECT_NEAR(result.statistics.std_mm, 0.05, 0.0015);
    EXPECT_NEAR(result.cloud_to_cloud_rmse_mm, 0, 1e-6);
    EXPECT_FALSE(contains(result.notes, NoteCode::EndForEnd));
}

TEST(Compare, DoesNotDependOnWhereTheScansLie)
{
    const Pair pair = makePair(6, {.copy = copiedShaft()});
    const CompareResult base = compare(pair.reference, pair.copy);
    const Isometry3d away = motion(2.1, 300);
    const CompareResult moved_reference = compare(movedBy(away, pair.reference), pair.copy);
    const CompareResult moved_copy = compare(pair.reference, movedBy(away, pair.copy));
    for (const CompareResult* other : {&moved_reference, &moved_copy}) {
        EXPECT_NEAR(other->statistics.mean_mm, base.statistics.mean_mm, 2e-4);
        EXPECT_NEAR(other->statistics.rmse_mm, base.statistics.rmse_mm, 2e-4);
    }
    const PoseError a =
        errorOf(moved_reference.alignment.reference_T_copy, away * pair.reference_T_part, pair.copy_T_part);
    const PoseError b = errorOf(moved_copy.alignment.reference_T_copy, pair.reference_T_part, away * pair.copy_T_part);
    for (const PoseError& e : {a, b}) {
        EXPECT_LT(e.axial_um, 6);
        EXPECT_LT(e.radial_um, 1);
        EXPECT_LT(e.axis_deg, 0.001);
    }
}

TEST(Compare, DoesNotDependOnTheOrderOfThePoints)
{
    Pair pair = makePair(7);
    const PoseError before =
        errorOf(compare(pair.reference, pair.copy).alignment.reference_T_copy, pair.reference_T_part, pair.copy_T_part);
    auto& points = pair.copy.points_mm;
    for (std::size_t i = points.size() - 1; i > 0; --i) std::swap(points[i], points[randomBits(3, 0, i) % (i + 1)]);
    const PoseError after =
        errorOf(compare(pair.reference, pair.copy).alignment.reference_T_copy, pair.reference_T_part, pair.copy_T_part);
    EXPECT_LT(std::max(before.axial_um, after.axial_um), 8);
    EXPECT_LT(std::max(before.radial_um, after.radial_um), 1);
    EXPECT_LT(std::max(before.axis_deg, after.axis_deg), 0.001);
}

TEST(Compare, GivesTheSameBitsForAnyNumberOfThreads)
{
    const Pair pair = makePair(8, {.dropout_share = 0.2, .spurious_share = 0.02});
    const CompareResult two = compare(pair.reference, pair.copy);
    const ThreadLimit limit(1);
    const CompareResult one = compare(pair.reference, pair.copy);
    EXPECT_EQ(
        std::memcmp(one.alignment.reference_T_copy.data(), two.alignment.reference_T_copy.data(), 16 * sizeof(double)),
        0);
    ASSERT_EQ(one.deviation_mm.size(), two.deviation_mm.size());
    EXPECT_EQ(std::memcmp(one.deviation_mm.data(), two.deviation_mm.data(), one.deviation_mm.size() * sizeof(float)),
              0);
    EXPECT_EQ(toJson(one).dump(), toJson(two).dump());
}

TEST(Compare, TakesAMeshAsTheReference)
{
    const Pair pair = makePair(9, {.copy = copiedShaft()});
    const Isometry3d pose = motion(0.4, 20);
    const Scan mesh = movedBy(pose, shaftMesh(nominalShaft()));
    const CompareResult result = compare(mesh, pair.copy);
    const PoseError e = errorOf(result.alignment.reference_T_copy, pose, pair.copy_T_part);
    EXPECT_EQ(result.method_used, CompareMethod::Revolution);
    EXPECT_LT(e.axial_um, 6);
    EXPECT_LT(e.radial_um, 1);
    EXPECT_LT(e.axis_deg, 0.001);
    EXPECT_NEAR(meanBetween(result, pair, 98.5, 107.5), 0.050, 0.003);
    EXPECT_NEAR(meanBetween(result, pair, 140, 146), 0.040, 0.003);
}

TEST(Compare, TakesAMeshAsTheCopy)
{
    const Pair pair = makePair(10);
    const Isometry3d pose = motion(0.2, 5);
    const CompareResult result = compare(pair.reference, movedBy(pose, shaftMesh(nominalShaft())));
    const PoseError e = errorOf(result.alignment.reference_T_copy, pair.reference_T_part, pose);
    EXPECT_LT(e.axial_um, 15);
    EXPECT_LT(e.radial_um, 1);
    EXPECT_EQ(result.deviation_mm.size(), shaftMesh(nominalShaft()).points_mm.size());
}

TEST(Compare, LeavesOutExcludedZonesAndFarPoints)
{
    const Pair pair = makePair(11, {.spurious_share = 0.02});
    CompareParameters parameters;
    parameters.exclude_z_mm = {{0, 30}, {150, 190}};
    parameters.tolerance_mm = 0.2;
    parameters.scanner_accuracy_mm = 0.15;
    const CompareResult result = compare(pair.reference, pair.copy, parameters);
    EXPECT_TRUE(contains(result.notes, NoteCode::ZonesExcluded));
    EXPECT_TRUE(contains(result.notes, NoteCode::OutliersExcluded));
    EXPECT_TRUE(contains(result.notes, NoteCode::NotDistinguishable));
    EXPECT_EQ(result.verdict, Verdict::Pass);
    EXPECT_EQ(result.distinguishable_from_scanner, false);
    EXPECT_NEAR(result.statistics.overlap_percent, 100 * 120.0 / 183 * 0.98, 1.5);
    EXPECT_EQ(result.statistics.points_used, std::accumulate(result.used.begin(), result.used.end(), std::int64_t{0}));
    const Isometry3d axis_T_copy = *result.axis_T_reference * result.alignment.reference_T_copy;
    for (std::size_t i = 0; i < pair.copy.points_mm.size(); ++i) {
        const double z = (axis_T_copy * pair.copy.points_mm[i]).z();
        EXPECT_TRUE(!result.used[i] || (z > 30 && z < 150));
        EXPECT_EQ(std::isnan(result.deviation_mm[i]), result.used[i] == 0);
    }
}

TEST(Compare, TreatsOtherPartsByTheGeneralMethod)
{
    const Scan reference = scanBracket(150000, 0.02, Isometry3d::Identity(), 1);
    const Isometry3d pose = motion(0.1, 3);
    const Scan copy = scanBracket(150000, 0.02, pose, 2);
    const CompareResult result = compare(reference, copy);
    EXPECT_EQ(result.method_used, CompareMethod::Plane);
    EXPECT_TRUE(contains(result.notes, NoteCode::MethodChosen));
    const Isometry3d off = result.alignment.reference_T_copy * pose;
    EXPECT_LT((off * Vector3d(50, 40, 45) - Vector3d(50, 40, 45)).norm(), 0.02);
    EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle() * 180 / std::acos(-1.0), 0.02);
    EXPECT_NEAR(result.statistics.mad_sigma_mm, 0.02, 0.002);
    EXPECT_TRUE(result.zones.empty());
    EXPECT_FALSE(result.meridian);
    CompareParameters forced;
    forced.method = CompareMethod::Revolution;
    EXPECT_EQ(errorOfRun([&] { compare(reference, copy, forced); }), ErrorCode::NotABodyOfRevolution);
    forced.method = CompareMethod::Auto;
    forced.symmetry = Symmetry::Revolution;
    EXPECT_EQ(errorOfRun([&] { compare(reference, copy, forced); }), ErrorCode::NotABodyOfRevolution);
}

TEST(Compare, RefusesPartsThatDoNotMatch)
{
    ShaftModel other{{.z_start_mm = 0, .z_end_mm = 60, .radius_start_mm = 30, .radius_end_mm = 30},
                     {.z_start_mm = 60, .z_end_mm = 150, .radius_start_mm = 22, .radius_end_mm = 22}};
    const Pair pair = makePair(12, {.copy = other});
    try {
        compare(pair.reference, pair.copy);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::PartsDoNotMatch);
        EXPECT_NE(find(error.values(), "overlap_percent"), nullptr);
    }
}

TEST(Compare, StaysNearThePoseAsScanned)
{
    const Pair pair = makePair(13);
    CompareParameters parameters;
    parameters.initial = InitialPose::Identity;
    const PoseError e = errorOf(compare(pair.reference, pair.copy, parameters).alignment.reference_T_copy,
                                pair.reference_T_part, pair.copy_T_part);
    EXPECT_LT(e.axial_um, 6);
    EXPECT_LT(e.radial_um, 1);
    const Pair turned = makePair(13, {.flip = true});
    EXPECT_FALSE(contains(compare(turned.copy, turned.copy, parameters).notes, NoteCode::EndForEnd));
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
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::pair<Scan, ErrorCode>> hostile{
        {Scan{}, ErrorCode::TooFewPoints},
        {cloud(2, [](double x, double y, double z) { return Vector3d(x, y, z); }), ErrorCode::TooFewPoints},
        {cloud(4, [](double x, double y, double z) { return Vector3d(x, y, z); }), ErrorCode::TooFewPoints},
        {cloud(1000, [](double, double, double) { return Vector3d(3, 4, 5); }), ErrorCode::PointsDegenerate},
        {cloud(1000, [](double x, double, double) { return Vector3d(3 * x, 4 * x, 50 * x); }),
         ErrorCode::PointsDegenerate},
        {cloud(1000, [](double x, double y, double) { return Vector3d(30 * x, 4 * y, 50 * x + y); }),
         ErrorCode::PointsDegenerate},
        {cloud(1000, [](double x, double y, double z) { return Vector3d(1e9 + x, y, z); }),
         ErrorCode::CoordinateTooLarge},
        {cloud(1000, [](double x, double y, double z) { return Vector3d(1e30 * x, 1e30 * y, z); }),
         ErrorCode::CoordinateTooLarge},
        {cloud(1000, [](double x, double y, double z) { return Vector3d(1e300 * x, -1e300 * y, z); }),
         ErrorCode::CoordinateTooLarge},
        {cloud(1000, [&](double x, double y, double z) { return Vector3d(x > 0.9 ? nan : x, y, z); }),
         ErrorCode::CoordinateTooLarge},
    };
    for (std::size_t k = 0; k < hostile.size(); ++k)
        for (const bool first : {true, false}) {
            const auto run = [&] { first ? compare(hostile[k].first, good) : compare(good, hostile[k].first); };
            EXPECT_EQ(errorOfRun(run), hostile[k].second) << "cloud " << k;
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
    EXPECT_EQ(errorOfRun([&] { compare(pair.reference, pair.copy, parameters); }), ErrorCode::ValueOutOfRange);
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
                            "verdict",
                            "distinguishable_from_scanner",
                            "cloud_to_cloud_rmse_mm",
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

TEST(Compare, MeetsTheTruthOfThePracticeData)
{
    const std::filesystem::path folder = LATHELIER_SOURCE_DIR "/../shared/data/scans";
    if (!std::filesystem::exists(folder / "shaft_truth.json")) GTEST_SKIP() << "no shared data";
    const FileBytes text((folder / "shaft_truth.json").string());
    const Json truth = Json::parse(text.view());
    const auto pose = [&](const char* key) {
        Isometry3d result;
        for (int r = 0; r < 4; ++r)
            for (int c = 0; c < 4; ++c)
                result.matrix()(r, c) = truth[key][static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
        return result;
    };
    Pair pair;
    pair.reference_T_part = pose("pose_original_part_to_scan");
    pair.copy_T_part = pose("pose_copy_part_to_scan");
    ImportOptions options;
    options.unit = LengthUnit::Millimetre;
    pair.copy = readScan((folder / "shaft_copy.ply").string(), options).scan;
    for (const char* reference : {"shaft_original.ply", "shaft_nominal.stl"}) {
        pair.reference = readScan((folder / reference).string(), options).scan;
        const CompareResult result = compare(pair.reference, pair.copy);
        const PoseError e = errorOf(result.alignment.reference_T_copy, pair.reference_T_part, pair.copy_T_part);
        EXPECT_LT(e.axial_um, 3) << reference;
        EXPECT_LT(e.radial_um, 0.5) << reference;
        EXPECT_LT(e.axis_deg, 0.0005) << reference;
        EXPECT_NEAR(meanBetween(result, pair, 98.5, 107.5), 0.050, 0.002) << reference;
        EXPECT_NEAR(meanBetween(result, pair, 140, 146), 0.040, 0.002) << reference;
        EXPECT_NEAR(meanBetween(result, pair, 0.5, 5.5), truthBetween(0.5, 5.5), 0.002) << reference;
        EXPECT_NEAR(meanBetween(result, pair, 92.5, 97.5), truthBetween(92.5, 97.5), 0.002) << reference;
    }
}

}  // namespace
}  // namespace lathelier
