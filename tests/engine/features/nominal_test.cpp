// Suggestions of nominal sizes: the worked examples, the series, and the shares of right and wrong ones by simulation.
#include "engine/features/nominal/nominal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/random.h"

namespace lathelier::features {
namespace {

using testing::Contains;

TEST(Nominal, WorkedExamplesOfDiameters)
{
    const Suggestion fifty = suggestDiameter(49.973, 0.002).value();
    EXPECT_EQ(fifty.quantity, "diameter_mm");
    EXPECT_EQ(fifty.nominal_mm, 50);
    EXPECT_EQ(fifty.grid_mm, 5);
    EXPECT_NEAR(fifty.difference_um, -27, 1e-6);
    EXPECT_NEAR(fifty.chance_percent.value(), 2.08, 1e-9);
    EXPECT_THAT(fifty.fits, Contains("f7"));
    const Suggestion tenth = suggestDiameter(33.7998, 0.0004).value();
    EXPECT_EQ(tenth.nominal_mm, 33.8);
    EXPECT_EQ(tenth.grid_mm, 0.1);
    EXPECT_NEAR(tenth.chance_percent.value(), 10, 1e-9);
}

TEST(Nominal, GridsCountOnlyWhereTheUncertaintyAllows)
{
    EXPECT_FALSE(suggestDiameter(33.8, 0.0051));
    EXPECT_EQ(suggestDiameter(33.8, 0.005)->grid_mm, 0.1);
    EXPECT_EQ(suggestDiameter(9.99, 0.01)->grid_mm, 5);
    EXPECT_EQ(suggestDiameter(5.01, 0.01)->grid_mm, 1);
    EXPECT_FALSE(suggestDiameter(0.01, 0.001));
    EXPECT_FALSE(suggestDiameter(std::numeric_limits<double>::quiet_NaN(), 0.001));
    EXPECT_FALSE(suggestDiameter(50, std::numeric_limits<double>::quiet_NaN()));
}

TEST(Nominal, Lengths)
{
    const Suggestion baseline = suggestLength(98.004, 0.006, "z_mm").value();
    EXPECT_EQ(baseline.quantity, "z_mm");
    EXPECT_EQ(baseline.nominal_mm, 98);
    EXPECT_EQ(baseline.grid_mm, 1);
    EXPECT_NEAR(baseline.chance_percent.value(), 10, 1e-9);
    EXPECT_EQ(suggestLength(183.02, 0.03)->nominal_mm, 183);
    EXPECT_FALSE(suggestLength(0.3, 0.001));
}

/// Draws sizes as a drawing has them (whole 75 %, half 15 %, tenth 10 %), or any; makes them to ±IT8/2 (40 %),
/// 0…-IT8 (40 %) or -IT8…-2·IT8 (20 %), measures them, and counts the suggestions, in percent.
struct Shares {
    double right = 0, wrong = 0;
};
Shares sharesOf(double U_mm, bool drawn)
{
    constexpr int count = 8000;
    Shares shares;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto uniform = [&](std::uint64_t stream) { return randomUniform(8, stream, i); };
        const double any = 8 + 72 * uniform(0), kind = uniform(1), place = uniform(2);
        const double parts = kind < 0.75 ? 1 : kind < 0.9 ? 2 : 10;
        const double nominal = std::round(any * parts) / parts;
        const double tolerance = standardTolerance_um(8, nominal).value() / 1000;
        const double off = place < 0.4   ? (uniform(3) - 0.5) * tolerance
                           : place < 0.8 ? -uniform(3) * tolerance
                                         : -(1 + uniform(3)) * tolerance;
        const double made = drawn ? nominal + off : any;
        const auto found = suggestDiameter(made + U_mm / 2 * randomNormal(8, 4, i), U_mm);
        if (!found) continue;
        (drawn && std::abs(found->nominal_mm - nominal) < 1e-9 ? shares.right : shares.wrong) += 100.0 / count;
    }
    return shares;
}

TEST(Nominal, SharesOfASimulation)
{
    struct Line {
        double U_mm, right, of_any;
    };
    for (const Line& line : {Line{0.002, 78, 23}, Line{0.01, 77, 15.5}, Line{0.03, 73, 11}}) {
        const Shares drawn = sharesOf(line.U_mm, true), any = sharesOf(line.U_mm, false);
        SCOPED_TRACE("right, wrong, of any: " +
                     testing::PrintToString(std::vector{drawn.right, drawn.wrong, any.wrong}));
        EXPECT_NEAR(drawn.right, line.right, 2) << line.U_mm;
        EXPECT_LT(drawn.wrong, 0.6) << line.U_mm;
        EXPECT_NEAR(any.wrong, line.of_any, 1.5) << line.U_mm;
    }
}

TEST(Nominal, Chamfers)
{
    const Suggestion one = suggestChamfer(1.03, 0.02, -45.3, 0.2).value();
    EXPECT_EQ(one.quantity, "leg_mm");
    EXPECT_EQ(one.nominal_mm, 1);
    EXPECT_EQ(one.designation, "1×45°");
    EXPECT_NEAR(one.difference_um, 30, 1e-9);
    EXPECT_EQ(suggestChamfer(0.5, 0.01, 30.9, 0.1)->designation, "0.5×30°");
    EXPECT_EQ(suggestChamfer(5, 0.03, 15.9, 0.1)->designation, "5×15°");
    EXPECT_FALSE(suggestChamfer(3.46, 0.02, 30, 0.1));
    EXPECT_FALSE(suggestChamfer(1, 0.02, 38, 0.5));
}

TEST(Nominal, OnlySizesWithinUOrTheirLimitsAgree)
{
    // 25.009 ± 0.001: k5 of 25 mm is +2…+11 µm, m5 +8…+17 µm.
    const Suggestion seat = suggestDiameter(25.009, 0.001).value();
    EXPECT_TRUE(seat.agrees);
    EXPECT_EQ(seat.tolerance, "k5");
    EXPECT_FALSE(suggestLength(45.098, 0.006, "z_mm")->agrees);
    EXPECT_TRUE(suggestLength(98.004, 0.006, "z_mm")->agrees);
    EXPECT_FALSE(suggestChamfer(0.697, 0.036, 45, 0.5)->agrees);
    EXPECT_TRUE(suggestChamfer(1.003, 0.036, 45.1, 0.5)->agrees);
    EXPECT_FALSE(suggestChamfer(1.003, 0.036, 45.7, 0.5)->agrees);
    EXPECT_TRUE(suggestRadius(1.04, 0.05)->agrees);
    EXPECT_FALSE(suggestRadius(1.04, 0.01)->agrees);
    EXPECT_TRUE(suggestThread(15.85, 0.007, 2)->agrees);                           // within 6g
    EXPECT_TRUE(suggestTapers({2.8624 + 0.004, 0.001, 24, 28, 40}).at(0).agrees);  // within AT8
    EXPECT_FALSE(suggestTapers({-30.1, 0.05, 26, 30, 3.46}).at(0).agrees);
    // Every chamfer is as near to a member of the series: no chance is given.
    EXPECT_FALSE(suggestChamfer(1.003, 0.036, 45.1, 0.5)->chance_percent);
    EXPECT_TRUE(suggestDiameter(25.009, 0.001)->chance_percent);
}

TEST(Nominal, Radii)
{
    const Suggestion one = suggestRadius(-1.04, 0.01).value();
    EXPECT_EQ(one.nominal_mm, 1);
    EXPECT_EQ(one.designation, "R1");
    EXPECT_NEAR(one.measured_mm, 1.04, 1e-12);
    EXPECT_EQ(suggestRadius(0.693, 0.12)->nominal_mm, 0.6);
    EXPECT_EQ(suggestRadius(60.03, 0.07)->designation, "R60");
    EXPECT_FALSE(suggestRadius(1.4, 0.01));
}

TEST(Nominal, Tapers)
{
    const auto ten = suggestTapers({2.8624, 0.02, 24, 28, 40});
    ASSERT_FALSE(ten.empty());
    EXPECT_EQ(ten[0].designation, "1:10");
    EXPECT_NEAR(ten[0].nominal_mm, 0.1, 1e-12);
    // Morse 4 and 5 differ by 0.020° of the half angle and by their diameters.
    const double four = std::atan(1 / (2 * 19.254)) * 180 / std::acos(-1.0);
    EXPECT_EQ(suggestTapers({four, 0.03, 26, 31.2, 100}).at(0).designation, "Morse 4");
    EXPECT_EQ(suggestTapers({four + 0.0195, 0.03, 37, 44.3, 129}).at(0).designation, "Morse 5");
    const auto two = suggestTapers({1.4307, 0.01, 14.6, 17.7, 64});
    EXPECT_EQ(two.at(0).designation, "Morse 2");
    EXPECT_EQ(two.at(1).designation, "1:20");
    EXPECT_EQ(suggestTapers({8.2972, 0.01, 30, 44, 50}).at(0).designation, "7:24");
    EXPECT_EQ(suggestTapers({-30.1, 0.05, 26, 30, 3.46}).at(0).designation, "30°");
    EXPECT_TRUE(suggestTapers({2.2, 0.02, 24, 28, 40}).empty());
}

TEST(Nominal, Threads)
{
    EXPECT_EQ(suggestThread(15.95, 0.007, 2.00013)->designation, "M16×2");
    EXPECT_EQ(suggestThread(16, 0.007, 2)->designation, "M16×2");
    EXPECT_EQ(suggestThread(15.9, 0.005, 1.5)->designation, "M16×1.5");
    EXPECT_EQ(suggestThread(5.9, 0.005, 1)->designation, "M6×1");
    EXPECT_FALSE(suggestThread(15.4, 0.005, 2));
    EXPECT_FALSE(suggestThread(15.95, 0.005, 2.117));
    EXPECT_FALSE(suggestThread(5.9, 0.005, 2));
}

TEST(Nominal, CirclipGrooves)
{
    const auto groove = circlipGrooveOf({20.001, 0.002}, {18.998, 0.003}, {1.31, 0.03}).value();
    EXPECT_EQ(groove.groove_mm, 19);
    EXPECT_EQ(groove.width_mm, 1.3);
    EXPECT_EQ(designationOf(groove), "DIN 471 - 20");
    EXPECT_FALSE(circlipGrooveOf({20, 0.002}, {18.5, 0.003}, {1.31, 0.03}));
    EXPECT_EQ(circlipBottomClass(groove), "h11");
    // On the seat of a bearing, k6 (+2…+15) or m6 (+8…+21) for 25 mm; a shaft of 25.1 mm has no ring.
    for (const double seat : {25.002, 25.009, 25.015, 25.021})
        EXPECT_EQ(circlipGrooveOf({seat, 0.001}, {23.85, 0.005}, {1.32, 0.01})->shaft_mm, 25);
    EXPECT_FALSE(circlipGrooveOf({25.1, 0.001}, {23.85, 0.005}, {1.32, 0.01}));
    EXPECT_FALSE(circlipGrooveOf({20, 0.002}, {19, 0.003}, {1.7, 0.03}));
    EXPECT_FALSE(circlipGrooveOf({21, 0.002}, {19, 0.003}, {1.3, 0.03}));
    // On the seat of a bearing: 25 n6 is +15 to +28 µm, 25 p6 begins at +22 and reaches to +35.
    EXPECT_EQ(designationOf(circlipGrooveOf({25.009, 0.002}, {23.9, 0.003}, {1.32, 0.03}).value()), "DIN 471 - 25");
    EXPECT_EQ(designationOf(circlipGrooveOf({25.029, 0.002}, {23.9, 0.003}, {1.32, 0.03}).value()), "DIN 471 - 25");
    EXPECT_FALSE(circlipGrooveOf({25.041, 0.002}, {23.9, 0.003}, {1.32, 0.03}));
}

TEST(Nominal, Undercuts)
{
    const auto named = [](UndercutForm form, double d, double t, double f, double r, double U) {
        const auto found = undercutOf({form, d, {t, U}, {f, U}, {r, U}});
        return found ? designationOf(*found, form) : "";
    };
    EXPECT_EQ(named(UndercutForm::E, 20, 0.201, 2.01, 0.62, 0.02), "DIN 509 - E 0.6×0.2");
    EXPECT_EQ(named(UndercutForm::E, 12, 0.201, 2.01, 0.42, 0.02), "DIN 509 - E 0.4×0.2");
    EXPECT_EQ(named(UndercutForm::F, 25, 0.302, 2.5, 0.95, 0.2), "DIN 509 - F 0.8×0.3");
    EXPECT_EQ(named(UndercutForm::E, 25, 0.6, 2.5, 0.8, 0.02), "");
    const auto [undercut, form] = undercutOf("DIN 509 - F 1.2×0.4").value();
    EXPECT_EQ(undercut.width_mm, 4);
    EXPECT_EQ(form, UndercutForm::F);
    EXPECT_FALSE(undercutOf("DIN 509 - G 0.6×0.2"));
    // The standard's own bracketed value.
    EXPECT_NEAR(faceExtent_mm({0.8, 0.3, 2.5, 0.2, 18, 80, false}), 2.3, 0.05);
}

}  // namespace
}  // namespace lathelier::features
