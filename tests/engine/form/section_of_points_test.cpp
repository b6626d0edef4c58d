#include "engine/form/roundness/section_of_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/profile_item.h"
#include "engine/core/random.h"
#include "engine/form/roundness/roundness.h"
#include "tests/engine/core/code_of_error.h"

namespace lathelier::form {
namespace {

/// A scan of a leaning shaft with three lobes of 40 µm (peak to valley 80) and noise.
std::vector<Eigen::Vector3d> scan(std::size_t count, double sigma_mm, const Eigen::Isometry3d& points_T_axis)
{
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * randomUniform(3, 0, i), z = 100 * randomUniform(3, 1, i);
        const double r = 20 + 0.04 * std::cos(3 * angle) + sigma_mm * randomNormal(3, 2, i);
        points.push_back(points_T_axis * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z));
    }
    return points;
}

const Eigen::Isometry3d leaning(Eigen::Translation3d(7, -4, 3) *
                                Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 1, 0.3).normalized()));

TEST(SectionOfPoints, HasTheFormOfTheScanAndLittleOfItsNoise)
{
    const Profile section = sectionOfPoints(scan(400000, 0.02, leaning), leaning.inverse(), {50, 2});
    EXPECT_GE(section.points_mm.size(), 300u);
    EXPECT_LE(section.points_mm.size(), 720u);
    RoundnessParameters parameters;
    parameters.cutoff_upr = 15;
    EXPECT_NEAR(roundness(section, parameters).circles.MZCI.RONt_um, 80, 6);
}

TEST(SectionOfPoints, TakesASparseSectionAsItIs)
{
    std::vector<Eigen::Vector3d> points;
    for (int z = 0; z < 3; ++z)
        for (int i = 0; i < 90; ++i) {
            const double angle = 2 * std::numbers::pi * i / 90;
            points.push_back(leaning * Eigen::Vector3d(10 * std::cos(angle), 10 * std::sin(angle), 5.0 * z));
        }
    const Profile section = sectionOfPoints(points, leaning.inverse(), {5, 1});
    ASSERT_EQ(section.points_mm.size(), 90u);
    for (const Eigen::Vector2d& p : section.points_mm) EXPECT_NEAR(p.norm(), 10, 1e-9);
    EXPECT_EQ(codeOfError([&] { sectionOfPoints(points, leaning.inverse(), {50, 1}); }), errors::tooFewPoints);
}

TEST(SectionOfPoints, GoesThroughAnItemUnchanged)
{
    Profile section = sectionOfPoints(scan(5000, 0, leaning), leaning.inverse(), {50, 2});
    section.name = "z 50 mm";
    const auto back = lathelier::profileOf(lathelier::toValues(section));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->name, section.name);
    EXPECT_EQ(back->points_mm, section.points_mm);
    EXPECT_FALSE(lathelier::profileOf({{"x_mm", std::vector<double>{1}}}));
    EXPECT_FALSE(lathelier::profileOf({{"x_mm", std::vector<double>{1}}, {"y_mm", std::vector<double>{1, 2}}}));
    EXPECT_FALSE(lathelier::profileOf({{"x_mm", std::vector<double>{std::nan("")}}, {"y_mm", std::vector<double>{1}}}));
}

}  // namespace
}  // namespace lathelier::form
