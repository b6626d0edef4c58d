// The local means that colour map and part: nearer to the truth than the points, sharp at shoulders, and empty without
// data.
#include "engine/registration/surface_form.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/parallel.h"
#include "engine/registration/compare_plots.h"
#include "tests/engine/registration/bumped_scan.h"

namespace lathelier::registration {
namespace {

using namespace testing_bump;

/// What the copy of the sample is larger or smaller than its original at a place of the part, as it was made.
double madeDeviation_mm(const ShaftScans& scans, const sample::ShaftModel& copy, const Eigen::Vector3d& copy_mm)
{
    const sample::ShaftModel nominal = sample::nominalShaft();
    const Eigen::Vector3d part = scans.copy_T_part.inverse() * copy_mm;
    return sample::radius_mm(copy, part.z()) - sample::radius_mm(nominal, part.z());
}

TEST(SurfaceForm, IsFarNearerToTheTruthThanThePointsAndSharpAtTheCollar)
{
    ShaftOptions options;
    options.copy = sample::copiedShaft();
    const ShaftScans scans = shaftTwice(5, options);
    const CompareResult result = compare(scans.reference, scans.copy);
    const std::vector<std::uint32_t> windows = windowsOfPoints(scans.copy, result);
    const double sigma_limit_mm = colourSigmaLimit_mm(result);
    EXPECT_LT(sigma_limit_mm, 0.01);
    const std::vector<float> form = meansOf(*result.windows, windows, sigma_limit_mm);
    ASSERT_EQ(form.size(), scans.copy.points_mm.size());
    double squares = 0, raw = 0, collar = 0, collar_points = 0;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < form.size(); ++i) {
        if (std::isnan(form[i])) continue;
        const double truth = madeDeviation_mm(scans, options.copy, scans.copy.points_mm[i]);
        if (std::abs(truth) > 0.2) continue;  // by the scanner's spot on the other side of a shoulder
        ++shown;
        squares += std::pow(static_cast<double>(form[i]) - truth, 2);
        raw += std::pow(static_cast<double>(result.deviation_mm[i]) - truth, 2);
        if (truth < 0.045) continue;
        collar += static_cast<double>(form[i]);
        collar_points += 1;
    }
    EXPECT_GT(static_cast<double>(shown), 0.9 * static_cast<double>(form.size()));
    const double rms = std::sqrt(squares / static_cast<double>(shown));
    EXPECT_LT(rms, 2 * sigma_limit_mm);
    EXPECT_LT(5 * rms, std::sqrt(raw / static_cast<double>(shown)));
    EXPECT_NEAR(collar / collar_points, 0.05, 0.003);
}

TEST(SurfaceForm, TheSameBitsForAnyNumberOfThreads)
{
    const ShaftScans scans = shaftTwice(6, {.step_deg = 6.6});
    const CompareResult result = compare(scans.reference, scans.copy);
    const std::vector<std::uint32_t> all = windowsOfPoints(scans.copy, result);
    const std::vector<std::uint32_t> map = windowsOfMap(result);
    const ThreadLimit one(1);
    EXPECT_EQ(windowsOfPoints(scans.copy, result), all);
    EXPECT_EQ(windowsOfMap(result), map);
}

TEST(SurfaceForm, WhatIsLeftOutHasNoColour)
{
    const ShaftScans scans = shaftTwice(7, {.step_deg = 6.6});
    CompareParameters asked;
    asked.exclude_z_mm = {{20, 40}};
    const CompareResult result = compare(scans.reference, scans.copy, asked);
    const std::vector<std::uint32_t> windows = windowsOfPoints(scans.copy, result);
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (result.used[i]) continue;
        ASSERT_EQ(windows[i], noWindow);
    }
    const std::vector<float> map = localMeansOfMap(result);
    const UnrolledMap& grid = *result.unrolled;
    const auto row = static_cast<std::size_t>((30 - grid.z_start_mm) / grid.z_step_mm);
    EXPECT_TRUE(std::isnan(map[row * static_cast<std::size_t>(grid.angle_count)]));
}

TEST(SurfaceForm, APartOfAnyShapeHasItToo)
{
    BoxScans scans;
    scans.reference = boxMesh();
    scans.copy = boxInLines(3, 0.03, 12, 0);
    CompareParameters asked;
    asked.symmetry = Symmetry::None;
    const CompareResult result = compare(scans.reference, scans.copy, asked);
    const std::vector<float> form =
        meansOf(*result.windows, windowsOfPoints(scans.copy, result), colourSigmaLimit_mm(result));
    double squares = 0;
    std::size_t shown = 0;
    for (const float mean : form) {
        if (std::isnan(mean)) continue;
        ++shown;
        squares += static_cast<double>(mean) * static_cast<double>(mean);
    }
    EXPECT_GT(static_cast<double>(shown), 0.85 * static_cast<double>(form.size()));
    EXPECT_LT(std::sqrt(squares / static_cast<double>(shown)), 0.006) << "the box is right, its noise 0.03 mm";
}

TEST(SurfaceForm, NothingToDecideWithoutWindows)
{
    const SurfaceWindows none;
    EXPECT_EQ(formLimit_mm(none, 0.98), 0);
    EXPECT_TRUE(std::isnan(meanOf(none, noWindow, 1)));
    EXPECT_TRUE(meansOf(none, {}, 1).empty());
}

}  // namespace
}  // namespace lathelier::registration
