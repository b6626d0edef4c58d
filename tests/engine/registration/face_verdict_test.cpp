// Faces across the axis: their place, the verdict about them, and where they are left out.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/units.h"
#include "engine/registration/compare.h"
#include "engine/registration/revolution/face_bins.h"
#include "engine/registration/surface_form.h"
#include "engine/registration/verdict/verdict.h"
#include "tests/engine/registration/bumped_scan.h"
#include "tests/engine/registration/within_tolerance.h"

namespace lathelier::registration {
namespace {

using namespace testing_bump;

const Finding* faceAt(const CompareResult& result, double z_mm)
{
    for (const Finding& f : result.findings)
        if (f.kind == Finding::Kind::Step && f.z_start_mm == f.z_end_mm && std::abs(*f.z_start_mm - z_mm) < 1)
            return &f;
    return nullptr;
}

/// How far the copy is moved along the reference's axis from where it belongs.
double axialError_mm(const ShaftScans& scans, const CompareResult& result)
{
    const Eigen::Vector3d middle(0, 0, 50);
    const Eigen::Vector3d off =
        result.alignment.reference_T_copy * (scans.copy_T_part * middle) - scans.reference_T_part * middle;
    return off.dot(scans.reference_T_part.linear().col(2));
}

TEST(FaceVerdict, APartThatIsTooLongIsOut)
{
    const ShaftScans scans = facedShafts(1, 0.05, 6, {.length_mm = 100.12});
    const CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.08));
    EXPECT_EQ(result.verdict, Verdict::Fail);
    // The axis may run either way: the face that differs is at one of the ends.
    const Finding* face = faceAt(result, 100) ? faceAt(result, 100) : faceAt(result, 0);
    ASSERT_TRUE(face);
    EXPECT_EQ(face->verdict, Verdict::Fail);
    EXPECT_LT(face->uncertainty_mm, 0.02);
    EXPECT_NEAR(face->value_mm, 0.12, face->uncertainty_mm);
    ASSERT_TRUE(result.worst);
    EXPECT_NEAR(result.worst->deviation_mm, 0.12, 0.03);
    EXPECT_EQ(compare(scans.reference, scans.copy, withinTolerance(0.2)).verdict, Verdict::Pass);
}

TEST(FaceVerdict, AShoulderThatIsMovedShowsAtBothEnds)
{
    const ShaftScans scans = facedShafts(2, 0.05, 6, {.shoulder_mm = 60.12});
    const CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.08));
    EXPECT_EQ(result.verdict, Verdict::Fail);
    const Finding* first = faceAt(result, 0);
    const Finding* last = faceAt(result, 100);
    ASSERT_TRUE(first && last);
    EXPECT_NEAR(std::abs(first->value_mm), 0.12, first->uncertainty_mm);
    EXPECT_NEAR(first->value_mm + last->value_mm, 0, 0.02);
}

TEST(FaceVerdict, TheSameShapeNeverFails)
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
        for (const double sigma : {0.03, 0.1}) {
            const ShaftScans scans = facedShafts(seed, sigma, sigma < 0.05 ? 4 : 12);
            const CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.03));
            EXPECT_NE(result.verdict, Verdict::Fail) << seed << " " << sigma;
            EXPECT_TRUE(result.findings.empty()) << seed << " " << sigma;
            EXPECT_EQ(result.alignment.free_motions.size(), 1U);
            EXPECT_LT(std::abs(axialError_mm(scans, result)), 0.002 * result.alignment.uncertainty.axial_um);
        }
}

TEST(FaceVerdict, WithoutAShoulderTheEndsSayNothing)
{
    const FacedShaft rod{.front_radius_mm = 20};
    const ShaftScans scans = facedShafts(3, 0.03, 4, {.front_radius_mm = 20, .length_mm = 100.5}, rod);
    const CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.08));
    EXPECT_EQ(result.alignment.free_motions.size(), 2U);
    EXPECT_TRUE(result.windows->faces.empty());
    EXPECT_EQ(result.verdict, Verdict::Pass);
}

TEST(FaceVerdict, FacesHaveALocalMeanToShow)
{
    const ShaftScans scans = facedShafts(4, 0.03, 4);
    const CompareResult result = compare(scans.reference, scans.copy, withinTolerance(0.08));
    const std::vector<std::uint32_t> windows = windowsOfPoints(scans.copy, result);
    std::size_t on_faces = 0;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const Eigen::Vector3d p = scans.copy_T_part.inverse() * scans.copy.points_mm[i];
        const double r = p.head<2>().norm();
        if (std::abs(p.z()) > 0.2 || r > 14) continue;
        ++on_faces;
        if (windows[i] != noWindow) ++shown;
    }
    ASSERT_GT(on_faces, 1000U);
    EXPECT_GT(static_cast<double>(shown), 0.95 * static_cast<double>(on_faces));
}

RadiusProfile profileOfRadii(const std::vector<double>& radius_mm, double step_mm)
{
    RadiusProfile profile;
    profile.step_mm = step_mm;
    profile.radius_mm = radius_mm;
    profile.slope.assign(radius_mm.size(), 0);
    profile.sigma_mm.assign(radius_mm.size(), 0.01);
    profile.points.assign(radius_mm.size(), 30);
    return profile;
}

TEST(FaceBins, ForgetsWhatNoiseMadeOfAFaceAndKeepsLandsAndSlopes)
{
    const auto side = [](double radius) { return std::vector<double>(12, radius); };
    std::vector<double> radii = side(20);
    radii.insert(radii.end(), {18.9, notANumber, notANumber, 16.4});
    const std::vector<double> front = side(15);
    radii.insert(radii.end(), front.begin(), front.end());
    radii.push_back(12);
    RadiusProfile shoulder = profileOfRadii(radii, 0.1);
    clearFaceBins(shoulder, 0.1);
    for (const std::size_t bin : {12U, 15U, 28U}) EXPECT_TRUE(std::isnan(shoulder.radius_mm[bin])) << bin;
    EXPECT_EQ(shoulder.radius_mm[11], 20);
    EXPECT_EQ(shoulder.radius_mm[16], 15);

    // The same bins of 2 mm are lands of the part.
    RadiusProfile lands = profileOfRadii(radii, 2);
    clearFaceBins(lands, 0.1);
    EXPECT_EQ(lands.radius_mm[12], 18.9);
    // A groove is not between its sides, and a steep cone has many bins.
    RadiusProfile groove =
        profileOfRadii({20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 17, 20, 20, 20, 20, 20, 20, 20, 20, 20}, 0.1);
    clearFaceBins(groove, 0.1);
    EXPECT_EQ(groove.radius_mm[10], 17);
    std::vector<double> slope = side(20);
    for (int i = 1; i <= 6; ++i) slope.push_back(20 - 0.5 * i);
    const std::vector<double> low = side(16.5);
    slope.insert(slope.end(), low.begin(), low.end());
    RadiusProfile cone = profileOfRadii(slope, 0.1);
    clearFaceBins(cone, 0.05);
    EXPECT_EQ(cone.radius_mm[13], 19);
}

}  // namespace
}  // namespace lathelier::registration
