// Three ways: our circles beside CGAL's and ALGLIB's, where these are installed and solve the same problem.
#include <gtest/gtest.h>

#include "engine/form/circle/circles.h"
#include "tests/engine/form/form_data.h"
#include "tests/engine/form/profiles.h"
#include "tests/peers/circle_peers.h"

namespace lathelier::form {
namespace {

#if defined(LATHELIER_WITH_CGAL) || defined(LATHELIER_WITH_ALGLIB)
/// Turned profiles, some with gaps, and the practice data when they are there.
std::vector<Points> nearlyRound()
{
    std::vector<Points> all;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const auto form = [&](double t) {
            return 25 + 0.004 * std::cos(2 * t + static_cast<double>(seed)) + 0.002 * std::cos(3 * t) +
                   0.001 * randomNormal(seed, 0, static_cast<std::uint64_t>(1e6 * t));
        };
        all.push_back(profileOf(40 + 25 * seed, form, {0.05, -0.03}));
        if (seed % 3 == 0) all.back().erase(all.back().begin() + 5, all.back().begin() + 9);
    }
    for (const char* name : {"p10_turned_n200", "p13_outliers_n200", "p19_keyway_n3600"})
        all.push_back(readPoints(name));
    return all;
}
#endif

TEST(CirclesPeers, CgalEnclosesWithTheSameCircle)
{
#ifndef LATHELIER_WITH_CGAL
    FAIL() << "CGAL is not installed";
#else
    std::vector<Points> all = nearlyRound();
    for (std::uint64_t seed = 0; seed < 60; ++seed) all.push_back(scattered(seed, 4 + seed, 1));
    for (const Points& points : all) {
        const FittedCircle own = fitCircles(points).MCCI;
        const peers::Circle theirs = peers::cgalEnclosing(points);
        EXPECT_NEAR(own.radius_mm, theirs.outer, 1e-12 * theirs.outer);
        EXPECT_NEAR((own.centre_mm - theirs.centre).norm(), 0, 1e-7);
    }
#endif
}

// CGAL's annulus minimises Ro² - Ri². Taken for the minimum zone it is too wide, never narrower than ours.
TEST(CirclesPeers, CgalAnnulusIsNotTheMinimumZone)
{
#ifndef LATHELIER_WITH_CGAL
    FAIL() << "CGAL is not installed";
#else
    int wider = 0;
    double worst = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Points points = scattered(seed, 20, 0.5);
        const double own = fitCircles(points).MZCI.RONt_um / 1000;
        const double theirs = zoneAbout(points, peers::cgalAnnulus(points).centre);
        EXPECT_GE(theirs, own * (1 - 1e-9)) << seed;
        if (theirs > own * 1.0001) ++wider;
        worst = std::max(worst, theirs / own - 1);
    }
    EXPECT_GT(wider, 10);
    EXPECT_GT(worst, 0.01);
#endif
}

TEST(CirclesPeers, AlglibAgreesOnAllFour)
{
#ifndef LATHELIER_WITH_ALGLIB
    FAIL() << "ALGLIB is not installed (libalglib-dev)";
#else
    for (const Points& points : nearlyRound()) {
        SCOPED_TRACE(points.size());
        const ReferenceCircles own = fitCircles(points);
        const peers::Circle least_squares = peers::alglibLeastSquares(points);
        EXPECT_NEAR(own.LSCI.radius_mm, least_squares.outer, 1e-8);
        EXPECT_NEAR((own.LSCI.centre_mm - least_squares.centre).norm(), 0, 1e-7);
        EXPECT_NEAR(own.MCCI.radius_mm, peers::alglibEnclosing(points).outer, 1e-6);
        EXPECT_NEAR(own.MICI.radius_mm, peers::alglibInscribed(points).inner, 1e-6);
        const double zone = zoneAbout(points, peers::alglibMinimumZone(points).centre);
        EXPECT_NEAR(own.MZCI.RONt_um / 1000, zone, 1e-6);
        EXPECT_LE(own.MZCI.RONt_um / 1000, zone + 1e-12);
    }
#endif
}

}  // namespace
}  // namespace lathelier::form
