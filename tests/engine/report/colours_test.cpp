#include "engine/report/colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lathelier {
namespace {

using Vec = std::array<double, 3>;

Vec linear(report::Rgb c)
{
    const auto decode = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return {decode(c.red / 255.0), decode(c.green / 255.0), decode(c.blue / 255.0)};
}

/// CIE L*a*b*, D65: another space than the one the colours are made in.
Vec cielab(const Vec& rgb)
{
    const double x = 0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2];
    const double y = 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2];
    const double z = 0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2];
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    return {116 * f(y) - 16, 500 * (f(x / 0.95047) - f(y)), 200 * (f(y) - f(z / 1.08883))};
}

double distance(const Vec& p, const Vec& q)
{
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// How a person without green (deutan) or red (protan) cones sees it; Viénot, Brettel and Mollon 1999.
Vec deutan(const Vec& c)
{
    const double rg = 0.29275 * c[0] + 0.70725 * c[1];
    return {rg, rg, -0.02234 * c[0] + 0.02234 * c[1] + c[2]};
}
Vec protan(const Vec& c)
{
    const double rg = 0.11238 * c[0] + 0.88762 * c[1];
    return {rg, rg, 0.00401 * c[0] - 0.00401 * c[1] + c[2]};
}

TEST(Colours, DarkenEvenlyFromTheMiddleToBothEnds)
{
    for (const double sign : {-1.0, 1.0}) {
        double last = cielab(linear(report::divergingColour(0)))[0];
        double shortest = 1e9, longest = 0;
        for (int i = 1; i <= 20; ++i) {
            const Vec here = cielab(linear(report::divergingColour(sign * i / 20.0)));
            const Vec before = cielab(linear(report::divergingColour(sign * (i - 1) / 20.0)));
            EXPECT_LT(here[0], last);
            last = here[0];
            shortest = std::min(shortest, distance(here, before));
            longest = std::max(longest, distance(here, before));
        }
        EXPECT_LT(longest / shortest, 2.2);  // a rainbow reaches 10
        EXPECT_GT(shortest, 2.3);            // every twentieth is a just noticeable difference
    }
}

TEST(Colours, TellSignsApartWithoutRedOrGreenCones)
{
    for (int i = 5; i <= 20; ++i) {
        const Vec minus = linear(report::divergingColour(-i / 20.0));
        const Vec plus = linear(report::divergingColour(i / 20.0));
        EXPECT_GT(distance(cielab(deutan(minus)), cielab(deutan(plus))), 15);
        EXPECT_GT(distance(cielab(protan(minus)), cielab(protan(plus))), 15);
    }
}

bool isGreen(report::Rgb c)
{
    return c.green >= c.red && c.green >= c.blue && c.green > 200;
}

TEST(Colours, InsideToleranceIsToldFromOutsideByEveryone)
{
    const report::DeviationColours colours{0.2, 0.05};
    for (double in = -0.05; in <= 0.05; in += 0.01)
        for (double out = 0.0501; out < 0.4; out += 0.01)
            for (const double sign : {-1.0, 1.0}) {
                const Vec inside = linear(colours(in));
                const Vec outside = linear(colours(sign * out));
                EXPECT_GT(distance(cielab(inside), cielab(outside)), 30);
                EXPECT_GT(distance(cielab(deutan(inside)), cielab(deutan(outside))), 20) << in << " " << sign * out;
                EXPECT_GT(distance(cielab(protan(inside)), cielab(protan(outside))), 20) << in << " " << sign * out;
                EXPECT_GT(cielab(inside)[0] - cielab(outside)[0], 10) << "lighter, also in a grey print";
            }
}

TEST(Colours, InsideToleranceTheSignIsStillSeen)
{
    const Vec minus = linear(report::insideColour(-1));
    const Vec plus = linear(report::insideColour(1));
    EXPECT_GT(distance(cielab(minus), cielab(plus)), 25);
    EXPECT_GT(distance(cielab(deutan(minus)), cielab(deutan(plus))), 20);
    EXPECT_GT(distance(cielab(protan(minus)), cielab(protan(plus))), 20);
}

TEST(Colours, GreenOnlyWhereAToleranceIsGiven)
{
    const report::DeviationColours plain{0.2, {}};
    for (double v = -0.3; v <= 0.3; v += 0.001) EXPECT_FALSE(isGreen(plain(v)) && plain(v).green > plain(v).red + 20);
    const report::DeviationColours banded{0.2, 0.05};
    for (double v = -0.05; v <= 0.05; v += 0.001) EXPECT_TRUE(isGreen(banded(v))) << v;
    EXPECT_FALSE(isGreen(banded(0.0500001)));
    EXPECT_FALSE(isGreen(banded(-0.0500001)));
    EXPECT_EQ(banded(5), report::divergingColour(1));
    EXPECT_EQ(banded(-5), report::divergingColour(-1));
    const report::DeviationColours narrow{0.02,
                                          0.05};  // the scale ends inside the band: still a colour, no division by zero
    EXPECT_TRUE(isGreen(narrow(0.03)));
    EXPECT_EQ(narrow(0.06), report::divergingColour(1));
    EXPECT_TRUE(isGreen(report::DeviationColours{0.02, 0}(0)));
}

TEST(Colours, ContoursAreStepsAboutZero)
{
    report::DeviationColours contours{0.06, {}, 6};
    EXPECT_EQ(contours(0), report::divergingColour(0));
    EXPECT_EQ(contours(0.0049), contours(-0.0049));
    EXPECT_EQ(contours(0.0051), contours(0.0149));
    EXPECT_NE(contours(0.0049), contours(0.0051));
    EXPECT_EQ(contours(0.06), report::divergingColour(1));
    EXPECT_EQ(contours(-1), report::divergingColour(-1));
    contours.tolerance = 0.03;  // the band is green, and nothing is stepped
    EXPECT_NE(contours(0.0051), contours(0.0149));
}

TEST(Colours, LimitsAreRoundAndNotBelowTheData)
{
    EXPECT_DOUBLE_EQ(report::niceLimit(0.1), 0.1);
    EXPECT_DOUBLE_EQ(report::niceLimit(0.101), 0.15);
    EXPECT_DOUBLE_EQ(report::niceLimit(0.9), 1);
    EXPECT_DOUBLE_EQ(report::niceLimit(33), 40);
    EXPECT_DOUBLE_EQ(report::niceLimit(0), 1);
    EXPECT_DOUBLE_EQ(report::niceLimit(std::nan("")), 1);
    for (double v = 1e-4; v < 1e3; v *= 1.07) {
        EXPECT_GE(report::niceLimit(v), v * (1 - 1e-9));
        EXPECT_LE(report::niceLimit(v), v * 1.6);
    }
}

}  // namespace
}  // namespace lathelier
