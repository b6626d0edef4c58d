// Images of single revolutions: samples that are missing neither move nor roughen what the filter gives.
#include "engine/trajectory/surface_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::trajectory {
namespace {

constexpr std::size_t pointsPerTurn = 360;

/// Two revolutions of a workpiece with 3 lobes of 6 µm and a ripple of 2 µm at 60 UPR.
SectionSignals lobes()
{
    SectionSignals signals;
    signals.points = pointsPerTurn;
    signals.numbers = {0, 1};
    for (auto& values : signals.um) values.assign(2 * pointsPerTurn, 0.0);
    for (std::size_t i = 0; i < 2 * pointsPerTurn; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / pointsPerTurn;
        signals.um[0][i] = 3 * std::cos(3 * angle) + std::cos(60 * angle);
    }
    return signals;
}

RevolutionImages filtered(const SectionSignals& signals, const signal::TransmissionBand& band)
{
    std::vector<double> angle_deg;
    for (std::size_t i = 0; i < pointsPerTurn; ++i) angle_deg.push_back(static_cast<double>(i) * 360 / pointsPerTurn);
    return revolutionImages(signals, angle_deg, 50, Rotation::Same, band);
}

TEST(SurfaceImage, FilterOverGapsAgreesWithTheWholeRevolution)
{
    SectionSignals signals = lobes();
    const signal::TransmissionBand longWaves{std::nullopt, 15.0};
    EXPECT_NEAR(filtered(signals, {}).RONt_um[0], 8, 0.1);
    const double whole_um = filtered(signals, longWaves).RONt_um[0];
    EXPECT_NEAR(whole_um, 6, 0.2);
    for (const std::size_t i : {5u, 6u, 100u, 101u, 102u, 300u}) signals.at(0, 1, i) = notANumber;
    const RevolutionImages images = filtered(signals, longWaves);
    EXPECT_NEAR(images.RONt_um[0], whole_um, 1e-9);
    EXPECT_NEAR(images.RONt_um[1], whole_um, 0.2);            // beside gaps the filter has one side only
    EXPECT_TRUE(std::isfinite(images.envelope_min_mm[100]));  // the other revolution is there
}

TEST(SurfaceImage, ARevolutionWithHardlyASampleHasNoForm)
{
    SectionSignals signals = lobes();
    for (std::size_t i = 3; i < pointsPerTurn; ++i) signals.at(2, 1, i) = notANumber;
    const RevolutionImages images = filtered(signals, {std::nullopt, 15.0});
    EXPECT_TRUE(std::isfinite(images.RONt_um[0]));
    EXPECT_TRUE(std::isnan(images.RONt_um[1]));
}

}  // namespace
}  // namespace lathelier::trajectory
