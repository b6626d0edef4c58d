#include "engine/form/cylinder/cylinder_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/form/cylinder/cylindricity_plots.h"

namespace lathelier::form {
namespace {

/// Sections of a cylinder about an axis that leans, with a barrel and a bow toward the local x.
struct Bowed {
    Eigen::Isometry3d pose = Eigen::Isometry3d(Eigen::Translation3d(5, -3, 40) *
                                               Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 0).normalized()));
    std::vector<Eigen::Vector3d> points_mm;
    FittedCylinder cylinder;

    Bowed()
    {
        for (int s = 0; s < 11; ++s)
            for (int i = 0; i < 90; ++i) {
                const double angle = 2 * std::numbers::pi * i / 90, u = s / 5.0 - 1, middle = 1 - u * u;
                const double r = 10 + 0.004 * middle;
                points_mm.emplace_back(
                    pose * Eigen::Vector3d(r * std::cos(angle) + 0.006 * middle, r * std::sin(angle), 5.0 * s));
            }
        cylinder.axis_point_mm = pose * Eigen::Vector3d(0, 0, 25);
        cylinder.axis_direction = pose.linear() * Eigen::Vector3d::UnitZ();
        cylinder.radius_mm = 10;
    }
};

TEST(CylinderSurface, RowsAreTheSectionsAndCarryRadiusAndCentre)
{
    const Bowed bowed;
    const CylinderSurface surface = surfaceAbout(bowed.cylinder, bowed.points_mm, 11);
    ASSERT_EQ(surface.z_count, 11);
    EXPECT_NEAR(surface.z_step_mm, 5, 1e-9);
    for (std::size_t s = 0; s < 11; ++s) {
        const double u = static_cast<double>(s) / 5 - 1, middle = 1 - u * u;
        EXPECT_NEAR(surface.z_mm[s], 5.0 * static_cast<double>(s), 1e-6);
        EXPECT_NEAR(surface.mean_row_um[s], 4 * middle, 0.01);
        EXPECT_NEAR(std::hypot(surface.centre_x_um[s], surface.centre_y_um[s]), 6 * middle, 0.05);
        EXPECT_NEAR(surface.highest_um[s], 10 * middle, 0.02);
        EXPECT_NEAR(surface.lowest_um[s], -2 * middle, 0.02);
    }
}

TEST(CylinderSurface, APlaceGoesThereAndBack)
{
    const Bowed bowed;
    const CylinderSurface surface = surfaceAbout(bowed.cylinder, bowed.points_mm, 11);
    for (const double angle_deg : {0.0, 33.0, 181.0, 359.0}) {
        const Eigen::Vector2d back = placeAbout(surface, placeOnCylinder(surface, 12.5, angle_deg));
        EXPECT_NEAR(back.x(), 12.5, 1e-9);
        EXPECT_NEAR(back.y(), angle_deg, 1e-9);
    }
}

TEST(CylinderSurface, SameBitsForAnyNumberOfThreads)
{
    std::vector<Eigen::Vector3d> many;
    const Bowed bowed;
    for (int k = 0; k < 200; ++k) many.insert(many.end(), bowed.points_mm.begin(), bowed.points_mm.end());
    const CylinderSurface all = surfaceAbout(bowed.cylinder, many, 0);
    const ThreadLimit one(1);
    ASSERT_EQ(threadsAllowed(), 1u);
    const CylinderSurface single = surfaceAbout(bowed.cylinder, many, 0);
    EXPECT_EQ(all.deviation_mm, single.deviation_mm);
    const auto sameBits = [](const std::vector<double>& a, const std::vector<double>& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
    };
    EXPECT_TRUE(sameBits(all.centre_x_um, single.centre_x_um));
    EXPECT_TRUE(sameBits(all.mean_row_um, single.mean_row_um));
}

TEST(CylinderSurface, HalfACylinderHasNoCentre)
{
    std::vector<Eigen::Vector3d> half;
    for (const Eigen::Vector3d& p : Bowed().points_mm)
        if ((Bowed().pose.inverse() * p).y() > 1) half.push_back(p);
    const CylinderSurface surface = surfaceAbout(Bowed().cylinder, half, 11);
    EXPECT_TRUE(std::isnan(surface.centre_x_um[5]));
    EXPECT_FALSE(std::isnan(surface.mean_row_um[5]));
}

TEST(CylinderSurface, ThePicturesHaveUnitsAndTheZone)
{
    Bowed bowed;
    bowed.cylinder.CYLt_um = 12;
    const CylinderSurface surface = surfaceAbout(bowed.cylinder, bowed.points_mm, 11);
    CylindricityParameters parameters;
    parameters.tolerance_um = 20;
    const report::Plot radius = radiusAlongAxis(surface, parameters);
    ASSERT_EQ(radius.limits.size(), 4u);
    EXPECT_EQ(radius.limits[1].place, 6);
    EXPECT_EQ(radius.limits[3].place, 10);
    for (const report::Axis& axis : {radius.x, radius.y, centresAlongAxis(surface).y, unrolledCylinder(surface).value})
        EXPECT_FALSE(axis.unit.empty());
    EXPECT_GE(unrolledCylinder(surface).limit, 9);
}

}  // namespace
}  // namespace lathelier::form
