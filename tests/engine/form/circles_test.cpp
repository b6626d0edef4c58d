// Closed forms, traps and degenerate input of the four reference circles.
#include "engine/form/circle/circles.h"
#include "engine/core/core_codes.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/form/profiles.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;

ErrorCode circleRefusal(const Points& points)
{
    return codeOfError([&] { fitCircles(points); });
}

void expectAllZones(const ReferenceCircles& circles, double RONt_um, double within_um)
{
    for (const auto kind : {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI})
        EXPECT_NEAR(circles.of(kind).RONt_um, RONt_um, within_um) << name(kind);
}

TEST(Circles, OfLobesAreTheClosedForm)
{
    for (const int lobes : {3, 4, 5, 7, 11, 20}) {
        SCOPED_TRACE(lobes);
        const auto count = static_cast<std::size_t>(80 * lobes);  // peaks and valleys are sampled
        const Points points = profileOf(count, [&](double t) { return 25 + 0.003 * std::cos(lobes * t); }, {3, -7});
        const ReferenceCircles circles = fitCircles(points);
        expectAllZones(circles, 6, 1e-6);
        EXPECT_NEAR(circles.MCCI.radius_mm, 25.003, 1e-9);
        EXPECT_NEAR(circles.MICI.radius_mm, 24.997, 1e-9);
        EXPECT_NEAR(circles.MZCI.radius_mm, 25, 1e-9);
        EXPECT_NEAR(circles.LSCI.RONq_um, 3 / std::sqrt(2.0), 1e-4);
        EXPECT_NEAR((circles.MZCI.centre_mm - Vector2d(3, -7)).norm(), 0, 1e-8);
    }
}

TEST(Circles, OfAnEllipseWithItsTwoInscribedOnes)
{
    const double a = 10, b = 8;  // the maximum inscribed circle of the outline has radius b and the centre
    const Points points =
        profileOf(720, [&](double t) { return a * b / std::hypot(b * std::cos(t), a * std::sin(t)); });
    const ReferenceCircles circles = fitCircles(points);
    EXPECT_NEAR(circles.MCCI.radius_mm, a, 1e-12);
    EXPECT_NEAR(circles.MICI.radius_mm, b, 1e-3);
    EXPECT_GE(circles.MICI.radius_mm, b);
    EXPECT_NEAR(circles.MZCI.RONt_um, 2000, 1e-6);
    EXPECT_EQ(circles.MCCI.contacts.size(), 2U);
}

TEST(Circles, OfAPerfectCircleHaveNoDeviation)
{
    for (const std::size_t count : {4U, 5U, 100U, 3600U}) {
        const ReferenceCircles circles = fitCircles(profileOf(count, [](double) { return 25.0; }, {1, 2}));
        expectAllZones(circles, 0, 1e-10);
        EXPECT_NEAR(circles.LSCI.radius_mm, 25, 1e-13);
        EXPECT_LE(*circles.MZCI.certified_gap_um, 1e-6);
    }
}

TEST(Circles, FarFromTheOriginAreAsExact)
{
    const auto radius = [](double t) { return 25 + 0.004 * std::cos(3 * t) + 0.001 * std::cos(17 * t + 1); };
    const ReferenceCircles here = fitCircles(profileOf(500, radius));
    const ReferenceCircles far = fitCircles(profileOf(500, radius, {25e3, -17e3}));
    for (const auto kind :
         {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI}) {
        EXPECT_NEAR(far.of(kind).RONt_um, here.of(kind).RONt_um, 3e-8) << name(kind);  // the coordinates are rounded
        EXPECT_NEAR(far.of(kind).radius_mm, here.of(kind).radius_mm, 3e-11) << name(kind);
    }
}

TEST(Circles, OfPartialArcsStaySensible)
{
    for (const double turn : {0.2, 0.5, 1.5708, 2.5, 3.1, 3.2, 4.0}) {
        SCOPED_TRACE(turn);
        Points points = profileOf(
            90, [](double) { return 25.0; }, {4, 5}, turn, 0.3);
        const FittedCircle exact = fitLeastSquaresCircle(points);
        EXPECT_NEAR(exact.radius_mm, 25, 1e-9);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] += 1e-4 * Vector2d(randomNormal(1, 0, i), randomNormal(1, 1, i));
        const ReferenceCircles circles = fitCircles(points);
        EXPECT_LE(circles.MZCI.RONt_um, circles.LSCI.RONt_um);
        EXPECT_GE(circles.MICI.radius_mm, circles.LSCI.inner_radius_mm * (1 - 1e-14));
        // The inscribed circle does not grow out of the open side: its centre stays in the sector of the arc, where any
        // step leads toward a point; past half a turn it may also go back until the ends of the arc stop it.
        const double opening = turn < std::numbers::pi ? 1 : -std::cos(turn / 2);
        EXPECT_LE((circles.MICI.centre_mm - circles.LSCI.centre_mm).norm(), 1.01e-3 * circles.LSCI.RONt_um / opening);
    }
}

TEST(Circles, OfAFewPointsOnAnArcKeepTheInscribedOneNear)
{
    const ReferenceCircles circles = fitCircles(Points{{10, 0.001}, {9.003, 4.359}, {6.01, 8}, {0.002, 10}});
    EXPECT_NEAR(circles.MICI.radius_mm, 10, 0.1);
    EXPECT_LT(circles.MICI.centre_mm.norm(), 0.1);
}

// The trap of annulus algorithms (CGAL's Min_annulus_d): they minimise Ro² - Ri², which is another circle.
TEST(Circles, MinimumZoneIsTheNarrowestNotTheSmallestArea)
{
    const auto areaAbout = [](const Points& points, const Vector2d& c) {
        const double inner = innerRadiusAbout(points, c), width = zoneAbout(points, c);
        return width * (width + 2 * inner);
    };
    int differ = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Points points = scattered(seed, 25, 0.5);
        const FittedCircle zone = fitCircles(points).MZCI;
        // The least area near it, by a plain search: not where the zone is narrowest.
        Vector2d best = zone.centre_mm;
        for (double step = 0.1; step > 1e-9; step *= 0.5)
            for (int turns = 0, moved = 1; moved && turns < 1000; ++turns) {
                moved = 0;
                for (const Vector2d& way : {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1)})
                    if (areaAbout(points, best + step * way) < areaAbout(points, best)) {
                        best += step * way;
                        moved = 1;
                    }
            }
        EXPECT_GE(zoneAbout(points, best), zone.RONt_um / 1000 - 1e-12);
        if (zoneAbout(points, best) > 1.001 * zone.RONt_um / 1000) ++differ;
    }
    EXPECT_GT(differ, 3);
}

TEST(Circles, DuplicatesAndGapsDoNotChangeTheZones)
{
    const auto radius = [](double t) { return 25 + 0.004 * std::cos(2 * t + 1) + 0.002 * std::cos(9 * t); };
    Points points = profileOf(300, radius, {1, 1});
    points.erase(points.begin() + 40, points.begin() + 55);
    const ReferenceCircles once = fitCircles(points);
    const Points copy = points;
    points.insert(points.end(), copy.begin(), copy.end());
    const ReferenceCircles twice = fitCircles(points);
    for (const auto kind : {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI})
        EXPECT_NEAR(twice.of(kind).RONt_um, once.of(kind).RONt_um, 1e-9);
}

TEST(Circles, SayWhyTheyHaveNoAnswer)
{
    EXPECT_EQ(circleRefusal({}), errors::tooFewPoints);
    EXPECT_EQ(circleRefusal({{1, 0}, {0, 1}, {-1, 0}}), errors::tooFewPoints);
    EXPECT_EQ(circleRefusal({{1, 0}, {0, 1}, {-1, 0}, {1, 0}, {0, 1}}), errors::tooFewPoints);
    EXPECT_EQ(circleRefusal({{3, 4}, {3, 4}, {3, 4}, {3, 4}}), errors::pointsDegenerate);
    EXPECT_EQ(circleRefusal({{0, 0}, {1, 1}, {2, 2}, {5, 5}, {7, 7}}), errors::pointsDegenerate);
    EXPECT_EQ(circleRefusal({{1e4, 0.1}, {1e4 + 1, 0.4}, {1e4 + 2, 0.7}, {1e4 + 3, 1.0}}), errors::pointsDegenerate);
    EXPECT_EQ(circleRefusal({{0, 0}, {1, std::nan("")}, {2, 2}, {5, 1}, {7, 3}}), errors::coordinateTooLarge);
    EXPECT_EQ(circleRefusal({{0, 0}, {1, INFINITY}, {2, 2}, {5, 1}, {7, 3}}), errors::coordinateTooLarge);
    EXPECT_NO_THROW(fitCircles(Points{{0, 0}, {1, 1}, {2, 2}, {5, 5.001}}));
}

TEST(Circles, StopWhenCancelled)
{
    std::stop_source source;
    source.request_stop();
    const Points points = profileOf(1000, [](double t) { return 25 + 0.01 * std::cos(3 * t); });
    EXPECT_THROW(fitCircles(points, {}, Progress(source.get_token(), nullptr)), Cancelled);
}

}  // namespace
}  // namespace lathelier::form
