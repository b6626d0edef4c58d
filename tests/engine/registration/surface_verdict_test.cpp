// The verdict about the surface: pass, fail, undecided, and the coverage of the uncertainties.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/registration/compare.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/verdict/verdict.h"
#include "tests/engine/registration/bumped_scan.h"
#include "tests/engine/registration/within_tolerance.h"

namespace lathelier::registration {
namespace {

using namespace testing_bump;

/// Input of the verdict for a part that is no body of revolution.
CompareResult compareQuickly(const BoxScans& scans, CompareParameters asked)
{
    asked.symmetry = Symmetry::None;
    return compare(scans.reference, scans.copy, asked, {}, CompareDetail::Summary);
}

const Finding* findKind(const CompareResult& result, Finding::Kind kind, double z_mm)
{
    for (const Finding& finding : result.findings)
        if (finding.kind == kind && (!finding.z_start_mm || (*finding.z_start_mm <= z_mm && *finding.z_end_mm >= z_mm)))
            return &finding;
    return nullptr;
}

TEST(SurfaceVerdict, TheSameShapeTwicePassesWhateverTheNoise)
{
    for (const std::uint64_t seed : {1U, 2U}) {
        const ShaftScans scans = shaftTwice(seed, {.sigma_mm = 0.1, .step_deg = 6.6, .dropout = 0.3, .spurious = 0.02});
        CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.1));
        EXPECT_LT(*result.within_tolerance_percent, 70) << "a share of points would have failed it";
        EXPECT_NEAR(result.scatter_mm, 0.1, 0.003);
        for (const Zone& zone : result.zones) EXPECT_LT(std::abs(zone.mean_mm), 1.6 * zone.uncertainty_mm);
        EXPECT_NE(result.verdict, Verdict::Fail);
        judge(result, withinTolerance(0.12));
        EXPECT_EQ(result.verdict, Verdict::Pass);
        judge(result, withinTolerance(0.05));
        EXPECT_EQ(result.verdict, Verdict::Undecided) << "a plateau of 0.05 mm, 4 mm across, would not be seen";
        judge(result, withinTolerance(0.03, DecisionRule::Guarded));
        EXPECT_NE(result.verdict, Verdict::Fail);
    }
}

/// Rows 0.2 mm apart, a spot of 0.15 mm, and a part that does not lean against the rows: shoulders between two rows are
/// known to the row spacing only, the chamfer determines the shift.
TEST(SurfaceVerdict, RowsCoarserThanTheSpotMoveNothing)
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.2;
        scanner.angle_step_deg = 3.6;
        scanner.seed = 2 * seed;
        const Scan reference = sample::scanShaft(sample::nominalShaft(), scanner);
        scanner.seed = 2 * seed + 1;
        const Scan copy = sample::scanShaft(sample::nominalShaft(), scanner);
        const CompareResult result = compare(reference, copy, withinTolerance(0.05));
        EXPECT_EQ(result.verdict, Verdict::Pass) << seed;
        // Both stand upright at the same height: no shift is true.
        const double axial_um = 1000 * std::abs(result.alignment.reference_T_copy.translation().z());
        EXPECT_LT(axial_um, 1.6 * result.alignment.uncertainty.axial_um + 1) << seed;
    }
}

TEST(SurfaceVerdict, NamesTheCollarOfTheSample)
{
    const ShaftScans scans = shaftTwice(3, {.step_deg = 3.6, .copy = sample::copiedShaft()});
    CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.08));
    EXPECT_EQ(result.verdict, Verdict::Pass);
    judge(result, withinTolerance(0.04));
    EXPECT_EQ(result.verdict, Verdict::Fail);
    const Finding* collar = findKind(result, Finding::Kind::Step, 103);
    ASSERT_TRUE(collar);
    EXPECT_EQ(collar->verdict, Verdict::Fail);
    EXPECT_EQ(collar->limit_mm, 0.04);
    EXPECT_LT(collar->uncertainty_mm, 0.012);
    EXPECT_NEAR(collar->value_mm, 0.05, collar->uncertainty_mm);
    EXPECT_TRUE(findKind(result, Finding::Kind::Taper, 50));
    EXPECT_TRUE(findKind(result, Finding::Kind::Barrel, 140));
    ASSERT_TRUE(result.worst);
    EXPECT_NEAR(*result.worst->z_mm, 103, 6);
    EXPECT_NEAR(result.worst->deviation_mm, 0.05, result.worst->uncertainty_mm);
}

TEST(SurfaceVerdict, SeesASmallBumpOnAShaft)
{
    ShaftScans scans = shaftTwice(4, {.sigma_mm = 0.05, .step_deg = 3});
    EXPECT_EQ(compare(scans.reference, scans.copy, withinTolerance(0.08)).verdict, Verdict::Pass);
    addBump(scans, 4, 0.12, 4);
    const CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.08));
    EXPECT_EQ(result.verdict, Verdict::Fail);
    EXPECT_GT(*result.within_tolerance_percent, 85);
    ASSERT_TRUE(result.worst);
    EXPECT_NEAR(*result.worst->z_mm, scans.bump_z_mm, 2);
    EXPECT_TRUE(findKind(result, Finding::Kind::Bump, scans.bump_z_mm));
}

TEST(SurfaceVerdict, SeesASmallBumpOnABox)
{
    const BoxScans scans = boxTwice(5, 0.03, 12, 0.12, 4, true);
    const CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.08));
    EXPECT_EQ(result.verdict, Verdict::Fail);
    ASSERT_TRUE(result.worst);
    EXPECT_LT((result.worst->point_mm - scans.bump_mm).norm(), 2);
    EXPECT_FALSE(result.worst->z_mm);
    const BoxScans same = boxTwice(5, 0.03, 12, 0, 4, true);
    EXPECT_EQ(compare(same.reference, same.copy, withinTolerance(0.08)).verdict, Verdict::Pass);
}

TEST(SurfaceVerdict, SeesASmallBumpOnABoxWhateverTheReferencesNoise)
{
    for (const std::uint64_t seed : {1U, 4U, 7U}) {
        const BoxScans scans = boxTwice(seed, 0.05, 12, 0.12, 4, false);
        CompareResult result = compareQuickly(scans, withinTolerance(0.08));
        EXPECT_EQ(result.verdict, Verdict::Fail) << seed;
        ASSERT_TRUE(result.worst);
        EXPECT_LT((result.worst->point_mm - scans.bump_mm).norm(), 2);
        const Finding* bump = findKind(result, Finding::Kind::Bump, 0);
        ASSERT_TRUE(bump);
        EXPECT_EQ(bump->verdict, Verdict::Fail);
        judge(result, withinTolerance(0.08, DecisionRule::Guarded));
        EXPECT_EQ(result.verdict, Verdict::Fail) << seed;
    }
}

TEST(SurfaceVerdict, NoiseAlikeAlongScanLinesNeverFails)
{
    const BoxScans scans = boxTwice(1, 0.05, 10, 0, 4, false, 1);
    CompareResult result = compareQuickly(scans, withinTolerance(0.03));
    EXPECT_NE(result.verdict, Verdict::Fail);
    judge(result, withinTolerance(0.03, DecisionRule::Guarded));
    EXPECT_NE(result.verdict, Verdict::Fail);
}

TEST(SurfaceVerdict, SaysWhatWouldDecide)
{
    const ShaftScans scans = shaftTwice(6, {.sigma_mm = 0.1, .step_deg = 9});
    CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.0005));
    EXPECT_EQ(result.verdict, Verdict::Undecided);
    EXPECT_TRUE(contains(result.notes, notes::scanTooPoor));
    judge(result, withinTolerance(0.06));
    EXPECT_EQ(result.verdict, Verdict::Undecided);
    EXPECT_FALSE(contains(result.notes, notes::scanTooPoor));
    const auto hidden = std::find_if(result.notes.begin(), result.notes.end(),
                                     [](const Note& note) { return note.code == notes::smallDefectsHidden; });
    ASSERT_NE(hidden, result.notes.end());
    const auto size_mm = std::get<double>(hidden->values.at(0).second);
    EXPECT_GT(size_mm, 4.5);
    EXPECT_LT(size_mm, 7);
    judge(result, withinTolerance(0.1));
    EXPECT_EQ(result.verdict, Verdict::Pass);
}

TEST(SurfaceVerdict, FacetsOfACoarseMeshAreNoDeviation)
{
    const ShaftScans scans = shaftTwice(7, {.step_deg = 6.6});
    const CompareResult result =
        compare(sample::shaftMesh(sample::nominalShaft(), 36), scans.copy, withinTolerance(0.03));
    EXPECT_NE(result.verdict, Verdict::Fail);
    EXPECT_TRUE(contains(result.notes, notes::facetsCoarse));
    EXPECT_TRUE(result.findings.empty());
}

TEST(SurfaceVerdict, AFileComparedWithItselfIsZeroToTheLastDigits)
{
    const Scan mesh = sample::shaftMesh(sample::nominalShaft(), 60);
    for (const Symmetry symmetry : {Symmetry::Auto, Symmetry::None}) {
        CompareParameters asked = withinTolerance(0.001, DecisionRule::Guarded);
        asked.symmetry = symmetry;
        const CompareResult result = compare(mesh, mesh, asked);
        EXPECT_LT(result.statistics.rmse_mm, 1e-11);
        EXPECT_EQ(result.verdict, Verdict::Pass);
    }
}

TEST(SurfaceVerdict, ZonesHaveLimitsOfTheirOwn)
{
    const ShaftScans scans = shaftTwice(8, {.step_deg = 6.6, .copy = sample::copiedShaft()});
    CompareParameters asked = withinTolerance(0.06);
    asked.zones = {{"collar", 98.5, 107.5, 0.0, 0.1}, {"grip", 0, 20, {}, {}}};
    CompareResult result = compare(scans.reference, scans.copy, asked);
    EXPECT_EQ(result.verdict, Verdict::Pass);
    ASSERT_EQ(result.zones.size(), 2u);
    EXPECT_EQ(result.zones[0].name, "grip");
    EXPECT_FALSE(result.zones[0].verdict);
    EXPECT_EQ(result.zones[1].verdict, Verdict::Pass);
    EXPECT_NEAR(result.zones[1].mean_mm, 0.05, result.zones[1].uncertainty_mm);
    asked.zones[0].upper_mm = 0.02;
    judge(result, asked);
    EXPECT_EQ(result.verdict, Verdict::Fail);
    EXPECT_EQ(result.zones[1].verdict, Verdict::Fail);
    asked.tolerance_mm.reset();  // only zones have limits
    asked.zones = {{"end", 120, 170, -0.05, 0.07}};
    judge(result, asked);
    EXPECT_EQ(result.verdict, Verdict::Pass);
}

TEST(SurfaceVerdict, AMissingStretchIsNamed)
{
    ShaftScans scans = shaftTwice(9, {.step_deg = 6.6});
    const Eigen::Isometry3d part_T_copy = scans.copy_T_part.inverse();
    std::erase_if(scans.copy.points_mm, [&](const Eigen::Vector3d& p) {
        const double z = (part_T_copy * p).z();
        return z > 40 && z < 52;
    });
    const CompareResult result = compare(scans.reference, scans.copy);
    const Finding* missing = findKind(result, Finding::Kind::Missing, 46);
    ASSERT_TRUE(missing);
    EXPECT_NEAR(missing->value_mm, 12, 2);
    EXPECT_FALSE(missing->verdict);
    EXPECT_FALSE(result.verdict);
}

TEST(SurfaceVerdict, IsTheSameForAnyNumberOfThreads)
{
    ShaftScans scans = shaftTwice(10, {.step_deg = 6.6, .copy = sample::copiedShaft()});
    const CompareResult all = compare(scans.reference, scans.copy, withinTolerance(0.04));
    const ThreadLimit one(1);
    const CompareResult alone = compare(scans.reference, scans.copy, withinTolerance(0.04));
    ASSERT_EQ(all.windows->windows.size(), alone.windows->windows.size());
    for (std::size_t i = 0; i < all.windows->windows.size(); ++i) {
        EXPECT_EQ(all.windows->windows[i].mean_mm, alone.windows->windows[i].mean_mm);
        EXPECT_EQ(all.windows->windows[i].sigma_mm, alone.windows->windows[i].sigma_mm);
    }
    EXPECT_EQ(all.worst->deviation_mm, alone.worst->deviation_mm);
}

}  // namespace
}  // namespace lathelier::registration
