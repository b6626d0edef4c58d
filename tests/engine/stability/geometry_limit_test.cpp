// Limits from geometry against a search of the exact receptance around every natural frequency.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/stability/boundary.h"
#include "engine/stability/depth_digits.h"
#include "engine/stability/pass/cut_shaft.h"
#include "engine/stability/pass/lobes_over_pass.h"
#include "tests/engine/stability/machines.h"

namespace lathelier::stability {
namespace {

using receptance::SpindleReceptance;
using receptance::SpindleSprings;

Shaft bar(double diameter_mm, double length_mm, double loss_factor)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, 0, {}, {}}};
    shaft.material.emplace();
    shaft.material->loss_factor = loss_factor;
    return shaft;
}

double realPartAt(const Shaft& shaft, const SpindleReceptance& chuck, double z_mm, double frequency_hz)
{
    receptance::ReceptanceParameters one;
    one.respond_z_mm = one.excite_z_mm = z_mm;
    one.from_hz = one.to_hz = frequency_hz;
    return receptanceOf(shaft, *shaft.material, one, {chuck, {}}).value.front().real();
}

/// The least real part by golden section beside each natural frequency: it lies at most at f (1 + η).
double leastOfAll(const Shaft& shaft, const SpindleReceptance& chuck, double z_mm,
                  const std::vector<double>& natural_hz)
{
    const double shrink = (std::sqrt(5.0) - 1) / 2;
    double least = 0;
    for (const double natural : natural_hz) {
        double from = natural, to = natural * 1.08;
        for (int step = 0; step < 60; ++step) {
            const double a = to - shrink * (to - from), b = from + shrink * (to - from);
            if (realPartAt(shaft, chuck, z_mm, a) < realPartAt(shaft, chuck, z_mm, b))
                to = b;
            else
                from = a;
        }
        least = std::min(least, realPartAt(shaft, chuck, z_mm, (from + to) / 2));
    }
    return least;
}

TEST(LimitFromGeometry, IsExactForSlenderAndStoutShaftsOnStiffAndSoftChucks)
{
    for (const SpindleSprings& springs :
         {SpindleSprings{1e5, 2e9, 0.06}, SpindleSprings{3e5, 1e10, 0.002}, SpindleSprings{15000, 197.4e6, 0.06}})
        for (const double diameter : {12.0, 20.0, 40.0})
            for (const double slenderness : {5.0, 12.0, 20.0})
                for (const double loss : {0.002, 0.01}) {
                    const Shaft shaft = bar(diameter, slenderness * diameter, loss);
                    const SpindleReceptance chuck{springs};
                    const auto computed = shaftReceptance(shaft, {}, chuck, {}, receptance::LinesOf::Refined);
                    const double truth = leastOfAll(shaft, chuck, 0, *computed.natural_frequencies_hz);
                    EXPECT_FALSE(leastRealPart(computed.frf).at_edge) << diameter << " " << slenderness;
                    EXPECT_NEAR(leastRealPart(computed.frf).real_mm_N / truth, 1, 0.005)
                        << springs.radial_N_mm << " D" << diameter << " L/D " << slenderness << " " << loss;
                }
}

/// At slow speeds the lobes lie so close that one of them is at its least depth.
TEST(LimitFromGeometry, IsExactOverAPass)
{
    const Shaft stock = bar(20, 300, 0.002);
    const SpindleReceptance chuck{SpindleSprings{1e5, 2e9, 0.06}};
    PassParameters pass;
    pass.pass_z_mm = {{0, 200}};
    pass.pass_depth_mm = 0.1;
    pass.pass_stations = 3;
    LobeParameters lobes;
    lobes.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    lobes.speed_rpm = {{150, 300}};
    const PassResult found = lobesOverPass(stock, pass, {}, {chuck, {}}, lobes);
    for (const PassStation& station : found.stations) {
        const Shaft now = cutShaft(stock, 0, station.z_mm, 0.1);
        receptance::ReceptanceParameters at_tool;
        at_tool.respond_z_mm = at_tool.excite_z_mm = station.z_mm;
        const auto natural = *shaftReceptance(now, at_tool, chuck).natural_frequencies_hz;
        const double truth = -1 / (2 * coefficient_N_mm2 * leastOfAll(now, chuck, station.z_mm, natural));
        ASSERT_TRUE(station.minimum_mm) << station.z_mm;
        EXPECT_NEAR(*station.minimum_mm / truth, 1, 0.005) << station.z_mm;
    }
}

TEST(DepthDigits, ShowThreeDigitsOfASmallDepth)
{
    EXPECT_EQ(depthDecimals(1.5), 3);
    EXPECT_EQ(depthDecimals(0.25), 3);
    EXPECT_EQ(depthDecimals(0.02), 4);
    EXPECT_EQ(depthDecimals(0.00026979), 6);
    EXPECT_EQ(depthDecimals(0), 3);
    EXPECT_EQ(depthDecimals(NAN), 3);
    EXPECT_DOUBLE_EQ(roundedDepth(0.000269791), 0.000270);
}

}  // namespace
}  // namespace lathelier::stability
