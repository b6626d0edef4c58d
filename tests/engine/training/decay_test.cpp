// The decay after a blow against its closed form, and the damping read from it.
#include "engine/training/decay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lathelier::training {
namespace {

TEST(Decay, ShowsTheDampingOfItsMode)
{
    for (const double damping : {0.005, 0.02, 0.05, 0.15, 0.4}) {
        const std::vector<stability::Mode> modes{{223, damping, 1e4}};
        const std::vector<Peak> peaks = peaksOf(ringDown(modes, 0.2));
        ASSERT_GE(peaks.size(), 3U) << damping;
        const double decrement = logDecrement(peaks[0].deflection_mm, peaks[2].deflection_mm, 2);
        EXPECT_NEAR(dampingRatio(decrement), damping, 1e-3 * damping);
        const double period = (peaks[2].time_s - peaks[0].time_s) / 2;
        EXPECT_NEAR(1 / period, 223 * std::sqrt(1 - damping * damping), 0.02);
    }
}

TEST(Decay, ABlowGivesItsImpulseToTheModalMass)
{
    const stability::Mode mode{100, 0.02, 5e3};
    const Decay decay = ringDown(std::span(&mode, 1), 0.1);
    const double omega = 2 * std::numbers::pi * 100, speed = decay.deflection_mm[1] / decay.step_s;
    EXPECT_EQ(decay.deflection_mm[0], 0);
    EXPECT_NEAR(speed, omega * omega / 5e3, 0.01 * speed);  // p/m of 1 N·s
    EXPECT_NEAR(decay.seconds(), 0.1, 2 * decay.step_s);
}

TEST(Decay, ModesAddUp)
{
    const std::vector<stability::Mode> both{{150, 0.02, 5e3}, {420, 0.01, 2e4}};
    const Decay sum = ringDown(both, 0.1);
    // The second mode alone has the same step, for it is the highest.
    const Decay high = ringDown(std::span(both).subspan(1), 0.1);
    ASSERT_EQ(sum.deflection_mm.size(), high.deflection_mm.size());
    const double w = 2 * std::numbers::pi * 150, wd = w * std::sqrt(1 - 0.02 * 0.02);
    for (std::size_t i = 0; i < sum.deflection_mm.size(); i += 97) {
        const double t = sum.step_s * static_cast<double>(i);
        EXPECT_NEAR(sum.deflection_mm[i] - high.deflection_mm[i],
                    w * w / 5e3 / wd * std::exp(-0.02 * w * t) * std::sin(wd * t), 1e-12);
    }
}

TEST(Decay, IsDrawn)
{
    const std::vector<stability::Mode> modes{{223, 0.03, 1e4}};
    const Decay decay = ringDown(modes, 0.5);
    const report::Plot plot = decayPlot(decay);
    ASSERT_EQ(plot.curves.size(), 1U);
    EXPECT_EQ(plot.curves[0].x.size(), decay.deflection_mm.size());
}

}  // namespace
}  // namespace lathelier::training
