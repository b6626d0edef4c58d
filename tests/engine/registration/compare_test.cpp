#include "engine/registration/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/io/cloud/scan_reader.h"
#include "engine/io/file.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/compare_report.h"
#include "engine/registration/registration_codes.h"
#include "engine/report/plain_text.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/registration/synthetic_pair.h"

namespace lathelier::registration {
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
    constexpr int profileSteps = 1000;
    for (int k = 0; k < profileSteps; ++k) {
        const double z = from_mm + (to_mm - from_mm) * (k + 0.5) / profileSteps;
        sum += radius_mm(sample::copiedShaft(), z) - radius_mm(sample::nominalShaft(), z);
    }
    return sum / profileSteps;
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

TEST(Compare, ReadsTheErrorsPutIntoTheCopy)
{
    const Pair pair = makePair(4, {.copy = sample::copiedShaft(), .angle_step_deg = 0.9});
    const CompareResult result = compare(pair.reference, pair.copy);
    EXPECT_EQ(result.method_used, CompareMethod::Revolution);
    for (const auto& [from, to] :
         {std::pair{0.5, 5.5}, {92.5, 97.5}, {98.5, 107.5}, {140.0, 146.0}, {108.5, 114.0}, {46.0, 52.0}})
        EXPECT_NEAR(meanBetween(result, pair, from, to), truthBetween(from, to), 0.002) << from << "…" << to;
    EXPECT_NEAR(meanBetween(result, pair, 98.5, 107.5), 0.050, 0.002);
    EXPECT_NEAR(meanBetween(result, pair, 140, 146), 0.040, 0.002);
    EXPECT_NEAR(meanBetween(result, pair, 178.5, 182.5), 0, 0.002);
    EXPECT_GT(result.statistics.overlap_percent, 99.9);
    EXPECT_GT(result.statistics.min_mm, -0.5);  // finite beside the edges as well
    EXPECT_LT(result.statistics.max_mm, 0.5);

    // The zones show the collar.
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
    EXPECT_FALSE(contains(result.notes, notes::endForEnd));
    EXPECT_TRUE(contains(result.notes, notes::samePoints));
    // The same points in another order count as another measurement.
    Scan turned = pair.reference;
    std::reverse(turned.points_mm.begin(), turned.points_mm.end());
    const CompareResult other = compare(pair.reference, turned);
    EXPECT_FALSE(contains(other.notes, notes::samePoints));
}

TEST(Compare, TheSurfaceOfACloudDiffersNowhereFromItselfByAnyMethod)
{
    const Scan scan = makePair(2, {.angle_step_deg = 9}).reference;
    for (const CompareMethod method :
         {CompareMethod::Auto, CompareMethod::Revolution, CompareMethod::Plane, CompareMethod::Point})
        for (const Symmetry symmetry : {Symmetry::Auto, Symmetry::None}) {
            if (method == CompareMethod::Revolution && symmetry == Symmetry::None) continue;
            CompareParameters asked;
            asked.method = method;
            asked.symmetry = symmetry;
            asked.tolerance_mm = 0.001;
            asked.decision = DecisionRule::Guarded;
            const CompareResult result = compare(scan, scan, asked);
            ASSERT_TRUE(result.worst);
            EXPECT_EQ(result.worst->deviation_mm, 0);
            EXPECT_EQ(result.worst->uncertainty_mm, 0);
            EXPECT_TRUE(result.findings.empty());
            EXPECT_GT(result.statistics.std_mm, 0.03) << "the points keep their noise";
            EXPECT_EQ(result.verdict, Verdict::Pass) << static_cast<int>(method) << static_cast<int>(symmetry);
        }
}

TEST(Compare, DoesNotDependOnWhereTheScansLie)
{
    const Pair pair = makePair(6, {.copy = sample::copiedShaft()});
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
    ASSERT_EQ(threadsAllowed(), 1u);
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
    const Pair pair = makePair(9, {.copy = sample::copiedShaft()});
    const Isometry3d pose = motion(0.4, 20);
    const Scan mesh = movedBy(pose, sample::shaftMesh(sample::nominalShaft()));
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
    const CompareResult result = compare(pair.reference, movedBy(pose, sample::shaftMesh(sample::nominalShaft())));
    const PoseError e = errorOf(result.alignment.reference_T_copy, pair.reference_T_part, pose);
    EXPECT_LT(e.axial_um, 15);
    EXPECT_LT(e.radial_um, 1);
    EXPECT_EQ(result.deviation_mm.size(), sample::shaftMesh(sample::nominalShaft()).points_mm.size());
}

TEST(Compare, TheSummaryAloneSaysTheSame)
{
    const Pair pair = makePair(12);
    CompareParameters parameters;
    parameters.tolerance_mm = 0.1;
    parameters.scanner_accuracy_mm = 0.05;
    const CompareResult whole = compare(pair.reference, pair.copy, parameters);
    const CompareResult less = compare(pair.reference, pair.copy, parameters, {}, CompareDetail::Summary);
    EXPECT_EQ(report::toPlainText(compareSummary(whole)), report::toPlainText(compareSummary(less)));
    EXPECT_EQ(whole.alignment.reference_T_copy.matrix(), less.alignment.reference_T_copy.matrix());
    EXPECT_EQ(whole.statistics.rmse_mm, less.statistics.rmse_mm);
    EXPECT_EQ(whole.used, less.used);
    EXPECT_EQ(whole.verdict, less.verdict);
    EXPECT_EQ(whole.notes.size(), less.notes.size());
    EXPECT_TRUE(whole.unrolled && !whole.histogram.counts.empty());
}

TEST(Compare, LeavesOutExcludedZonesAndFarPoints)
{
    const Pair pair = makePair(11, {.spurious_share = 0.02});
    CompareParameters parameters;
    parameters.exclude_z_mm = {{0, 30}, {150, 190}};
    parameters.tolerance_mm = 0.2;
    parameters.scanner_accuracy_mm = 0.15;
    const CompareResult result = compare(pair.reference, pair.copy, parameters);
    EXPECT_TRUE(contains(result.notes, notes::zonesExcluded));
    EXPECT_TRUE(contains(result.notes, notes::outliersExcluded));
    EXPECT_TRUE(contains(result.notes, notes::notDistinguishable));
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
    const Scan reference = sample::scanBracket(150000, 0.02, Isometry3d::Identity(), 1);
    const Isometry3d pose = motion(0.1, 3);
    const Scan copy = sample::scanBracket(150000, 0.02, pose, 2);
    const CompareResult result = compare(reference, copy);
    EXPECT_EQ(result.method_used, CompareMethod::Plane);
    EXPECT_TRUE(contains(result.notes, notes::methodChosen));
    const Isometry3d off = result.alignment.reference_T_copy * pose;
    EXPECT_LT((off * Vector3d(50, 40, 45) - Vector3d(50, 40, 45)).norm(), 0.02);
    EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle() * 180 / std::acos(-1.0), 0.02);
    EXPECT_NEAR(result.statistics.mad_sigma_mm, 0.02, 0.002);
    EXPECT_TRUE(result.zones.empty());
    EXPECT_FALSE(result.meridian);
    CompareParameters forced;
    forced.method = CompareMethod::Revolution;
    EXPECT_EQ(codeOfError([&] { compare(reference, copy, forced); }), errors::notABodyOfRevolution);
    forced.method = CompareMethod::Auto;
    forced.symmetry = Symmetry::Revolution;
    EXPECT_EQ(codeOfError([&] { compare(reference, copy, forced); }), errors::notABodyOfRevolution);
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
    EXPECT_FALSE(contains(compare(turned.copy, turned.copy, parameters).notes, notes::endForEnd));
}

TEST(Compare, MeetsTheTruthOfFullScansAndOfTheNominalMesh)
{
    PairOptions options;
    options.copy = sample::copiedShaft();
    options.angle_step_deg = 0.9;
    Pair pair = makePair(21, options);
    Scan mesh = sample::shaftMesh(sample::nominalShaft());
    for (Vector3d& point : mesh.points_mm) point = pair.reference_T_part * point;
    const Scan scan = std::move(pair.reference);
    for (const Scan* reference : {&scan, &std::as_const(mesh)}) {
        const CompareResult result = compare(*reference, pair.copy);
        const PoseError e = errorOf(result.alignment.reference_T_copy, pair.reference_T_part, pair.copy_T_part);
        EXPECT_LT(e.axial_um, 3) << reference->isMesh();
        EXPECT_LT(e.radial_um, 0.5) << reference->isMesh();
        EXPECT_LT(e.axis_deg, 0.0005) << reference->isMesh();
        EXPECT_NEAR(meanBetween(result, pair, 98.5, 107.5), 0.050, 0.002) << reference->isMesh();
        EXPECT_NEAR(meanBetween(result, pair, 140, 146), 0.040, 0.002) << reference->isMesh();
        EXPECT_NEAR(meanBetween(result, pair, 0.5, 5.5), truthBetween(0.5, 5.5), 0.002) << reference->isMesh();
        EXPECT_NEAR(meanBetween(result, pair, 92.5, 97.5), truthBetween(92.5, 97.5), 0.002) << reference->isMesh();
    }
}

}  // namespace
}  // namespace lathelier::registration
