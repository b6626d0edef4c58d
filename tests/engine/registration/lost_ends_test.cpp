// The axial position of a turned copy when the two scans lose different ends, and when the spot smears its shoulders.
#include <gtest/gtest.h>

#include <numbers>

#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution.h"
#include "tests/engine/registration/lost_ends.h"

namespace lathelier::registration {
namespace {

using namespace testing_lost_ends;
using namespace testing_steps;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using std::numbers::pi;

void expectAligned(const LostEnds& lost, std::uint64_t seed)
{
    EXPECT_NE(lost.result.verdict, Verdict::Fail) << seed;
    const double stated_um = lost.result.alignment.uncertainty.axial_um;
    EXPECT_EQ(std::isnan(stated_um), contains(lost.result.notes, notes::motionNotDetermined)) << seed;
    if (std::isnan(stated_um)) return;
    EXPECT_LE(std::abs(lost.axial_um), 5) << seed;
    EXPECT_LE(std::abs(lost.axial_um), 2 * stated_um) << seed;
}

TEST(LostEnds, ThreeStepsInAnyPose)
{
    const Steps shaft = {{40, 15}, {34, 19}, {50, 13}};
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const LostEnds lost = compareWithLostEnds(shaft, 36000, seed);
        EXPECT_EQ(lost.result.alignment.free_motions.size(), 1U) << seed;
        expectAligned(lost, seed);
    }
}

TEST(LostEnds, ShaftsWithTwoShoulders)
{
    for (std::uint64_t seed = 0; seed < 5; ++seed)
        expectAligned(compareWithLostEnds(randomShaft(seed), 40000, seed), seed);
}

TEST(LostEnds, EndsDetermineARodWhereBothScansShowOne)
{
    const Steps rod = {{90, 18}};
    const Isometry3d reference_T_part = anyPoseBy(1001), copy_T_part = anyPoseBy(1002);
    const Scan reference = scanEvenly(rod, 40000, 0.05, -1, 91, reference_T_part, 1);
    const Scan copy = scanEvenly(rod, 40000, 0.05, -1, 80, copy_T_part, 2);
    const CompareResult result = compare(reference, copy, withinTolerance(0.1));
    EXPECT_EQ(result.alignment.free_motions.size(), 1U);
    EXPECT_LE(result.alignment.uncertainty.axial_um, 10);
    EXPECT_NE(result.verdict, Verdict::Fail);
}

TEST(LostEnds, AnAxialPositionThatIsNotDeterminedHasNoUncertainty)
{
    const Steps rod = {{90, 18}};
    const Isometry3d reference_T_part = anyPoseBy(1003), copy_T_part = anyPoseBy(1004);
    const Scan reference = scanEvenly(rod, 40000, 0.05, -1, 85, reference_T_part, 3);
    const Scan copy = scanEvenly(rod, 40000, 0.05, 6, 91, copy_T_part, 4);
    const CompareResult result = compare(reference, copy, withinTolerance(0.1));
    EXPECT_EQ(result.alignment.free_motions.size(), 2U);
    EXPECT_TRUE(std::isnan(result.alignment.uncertainty.axial_um));
    EXPECT_EQ(result.verdict, Verdict::Pass);
}

TEST(MeanSpot, DoesNotDisplaceShouldersThatFaceOneWay)
{
    const Steps shaft = {{60, 13}, {60, 16}, {63, 20}};
    const double middle = lengthOf(shaft) / 2;
    const auto standing = [&](double tilt_deg, double azimuth, double offset_mm, double lift_mm) {
        return Isometry3d(Eigen::Translation3d(offset_mm, 0.3 * offset_mm, lift_mm + middle) *
                          Eigen::AngleAxisd(tilt_deg * pi / 180, Vector3d(std::cos(azimuth), std::sin(azimuth), 0)) *
                          Eigen::Translation3d(0, 0, -middle));
    };
    constexpr int pairs = 24;
    int covered = 0;
    int small = 0;  // not where the rows of the scan are parallel to the shoulder
    double sum_um = 0;
    for (std::uint64_t k = 0; k < pairs; ++k) {
        const auto draw = [&](std::uint64_t i) { return randomUniform(833, k, i); };
        MeanSpotScanner scanner;
        scanner.spot_mm = 0.15 + 0.35 * draw(0);
        scanner.seed = 5000 + 2 * k;
        const Isometry3d reference_T_part = standing(0.4, 0.5, 0.8, 0);
        const std::vector<Vector3d> reference_points = scanByMeanSpot(shaft, scanner, reference_T_part).points_mm;
        scanner.seed += 1;
        scanner.z_from_mm = 0;
        scanner.z_to_mm = lengthOf(shaft);
        const Isometry3d copy_T_part =
            standing(k % 3 == 0 ? 4 : 10 * draw(1), 2 * pi * draw(2), 3 * draw(3), 24 * draw(4) - 12);
        const std::vector<Vector3d> copy_points = scanByMeanSpot(shaft, scanner, copy_T_part).points_mm;
        TurnedPart reference{fitRevolution(reference_points), {}};
        TurnedPart copy{fitRevolution(copy_points), {}};
        const ShoulderPair shoulders = findShoulders(reference_points, reference.fit, copy_points, copy.fit);
        reference.shoulders = shoulders.reference;
        copy.shoulders = shoulders.copy;
        const Alignment alignment = alignRevolution(reference, copy, InitialPose::Auto);
        const double error_um = axialError_um(alignment.reference_T_copy, reference_T_part, copy_T_part, middle);
        covered += std::abs(error_um) <= alignment.uncertainty.axial_um ? 1 : 0;
        sum_um += error_um;
        EXPECT_LE(std::abs(error_um), 2.5 * alignment.uncertainty.axial_um) << k;
        small += alignment.uncertainty.axial_um <= 6 ? 1 : 0;
    }
    EXPECT_GE(covered, pairs * 90 / 100);
    EXPECT_GE(small, pairs * 80 / 100);
    EXPECT_LE(std::abs(sum_um / pairs), 3);
}

}  // namespace
}  // namespace lathelier::registration
