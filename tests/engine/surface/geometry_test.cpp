// Waves on an unrolled cylinder, against the worked example: D 30, f 0.1, N 2016, f_c 361.
#include "engine/surface/chatter_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lathelier::surface {
namespace {

using std::numbers::pi;

TEST(ChatterGeometry, WorkedExample)
{
    const Waves waves = wavesPerRevolution(361, 2016);
    EXPECT_EQ(waves.m, 11);
    EXPECT_NEAR(waves.nu, -0.256, 5e-4);
    EXPECT_NEAR(0.1 / std::abs(waves.nu), 0.391, 5e-4);
    EXPECT_NEAR(inclination_deg(waves.nu, waves.m, 30, 0.1), -87.4, 0.05);
    EXPECT_NEAR(phase_deg(waves.nu), 267.9, 0.05);
    EXPECT_NEAR(helixAngle_deg(0.1, 30), 0.061, 5e-4);
}

/// Every line K_c + j K_f of the lattice, or its opposite, reads as the same vibration for any camera orientation.
TEST(ChatterGeometry, EveryLineReadsTheSame)
{
    const double f = 0.1, D = 30, mm_per_px = 0.006;
    for (const double nu : {-0.256, 0.31, -0.49, 0.05})
        for (const double camera_deg : {0.0, 12.0, -70.0, 135.0})
            for (const CutDirection cut : {CutDirection::Down, CutDirection::Up})
                for (int j = -3; j <= 3; ++j)
                    for (const double sign : {1.0, -1.0}) {
                        const int m = 11;
                        const Vector z = turned({1, 0}, camera_deg);
                        const Vector y = turned(z, cut == CutDirection::Down ? 90 : -90);
                        const auto wave = [&](double k_y, double k_z) { return mm_per_px * (k_y * y + k_z * z); };
                        const Vector feed = wave(-1 / (pi * D), 1 / f);
                        const Vector chatter = wave(m / (pi * D), nu / f);
                        const Reading reading =
                            readingOf(sign * (chatter + double(j) * feed), feed, f, D, D / mm_per_px, cut);
                        EXPECT_NEAR(reading.nu, nu, 1e-9);
                        EXPECT_NEAR(*reading.waves, m, 1e-6);
                    }
}

TEST(ChatterGeometry, MirroringFlipsTheSign)
{
    const double f = 0.1, D = 30, mm_per_px = 0.006;
    const auto wave = [&](double k_y, double k_z) { return Vector{mm_per_px * k_z, mm_per_px * k_y}; };
    const Vector feed = wave(-1 / (pi * D), 1 / f), chatter = wave(11 / (pi * D), -0.256 / f);
    const Reading reading =
        readingOf({chatter.x, -chatter.y}, {feed.x, -feed.y}, f, D, D / mm_per_px, CutDirection::Up);
    EXPECT_NEAR(reading.nu, -0.256, 1e-9);
    const Reading wrong =
        readingOf({chatter.x, -chatter.y}, {feed.x, -feed.y}, f, D, D / mm_per_px, CutDirection::Down);
    EXPECT_NEAR(wrong.nu, 0.256, 1e-3);
    EXPECT_NEAR(*wrong.waves, 11, 0.6);
}

}  // namespace
}  // namespace lathelier::surface
