// Properties of the four reference circles on random points: order, invariance, and brute force.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/form/circle/circles.h"
#include "tests/engine/form/profiles.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;

constexpr std::array kinds{ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI};

/// Points all around with a spread of a thousandth to a half.
Points anyPoints()
{
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto count = *rc::gen::inRange<std::size_t>(8, 120);
    const double spread = std::pow(10.0, -3 + *rc::gen::inRange(0, 28) / 10.0);
    return scattered(seed, count, spread);
}

RC_GTEST_PROP(CirclesProperty, MinimumZoneIsNeverBeaten, ())
{
    const Points points = anyPoints();
    const ReferenceCircles circles = fitCircles(points);
    for (const auto kind : kinds) RC_ASSERT(circles.MZCI.RONt_um <= circles.of(kind).RONt_um * (1 + 1e-12) + 1e-9);
    RC_ASSERT(circles.MICI.radius_mm >= circles.LSCI.inner_radius_mm * (1 - 1e-14));
    RC_ASSERT(circles.MCCI.radius_mm <= circles.LSCI.outer_radius_mm * (1 + 1e-14));
    // Not by any centre tried at random either, without and with the certificate's help.
    CircleOptions quick;
    quick.certify = false;
    RC_ASSERT(fitCircles(points, quick).MZCI.RONt_um >= circles.MZCI.RONt_um - 1e-5);
    for (std::uint64_t i = 0; i < 300; ++i) {
        const Vector2d centre =
            circles.MZCI.centre_mm + std::pow(10.0, -5 * randomUniform(1, 2, i)) *
                                         Vector2d(randomUniform(1, 0, i) - 0.5, randomUniform(1, 1, i) - 0.5);
        RC_ASSERT(zoneAbout(points, centre) * 1000 >= circles.MZCI.RONt_um - *circles.MZCI.certified_gap_um - 1e-9);
    }
}

RC_GTEST_PROP(CirclesProperty, ContactsAreWhereTheCircleRests, ())
{
    const Points points = anyPoints();
    const ReferenceCircles circles = fitCircles(points);
    std::size_t outer = 0, inner = 0;
    for (const auto kind : {ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI}) {
        const FittedCircle& circle = circles.of(kind);
        for (const CircleContact& contact : circle.contacts) {
            const double distance = (points.at(contact.index) - circle.centre_mm).norm();
            const bool outside = contact.side == CircleContact::Side::Outer;
            RC_ASSERT(std::abs(distance - (outside ? circle.outer_radius_mm : circle.inner_radius_mm)) < 1e-9);
            if (kind == ReferenceCircle::MZCI) ++(outside ? outer : inner);
        }
    }
    RC_ASSERT(outer >= 1U);
    RC_ASSERT(inner >= 1U);
    RC_ASSERT(outer + inner >= 4U);
    RC_ASSERT(circles.MCCI.contacts.size() >= 2U);
}

TEST(Circles, AllContactsOfAZoneAreListedWhenItsLastStepIsCutShort)
{
    const ReferenceCircles circles = fitCircles(scattered(33110237378259, 9, 0.001));
    EXPECT_EQ(circles.MZCI.contacts.size(), 4u);
}

RC_GTEST_PROP(CirclesProperty, RotationTranslationScaleAndOrderDoNotMatter, ())
{
    const Points points = anyPoints();
    const ReferenceCircles before = fitCircles(points);
    const double scale = std::pow(10.0, *rc::gen::inRange(-3, 4)) * 1.7;
    const Eigen::Rotation2Dd rotation(0.001 * *rc::gen::inRange(0, 6283));
    const Vector2d shift = scale * Vector2d(*rc::gen::inRange(-1000, 1000), *rc::gen::inRange(-1000, 1000));
    Points moved;
    for (const Vector2d& point : points) moved.push_back(shift + scale * (rotation * point));
    std::sort(moved.begin(), moved.end(), [](const Vector2d& a, const Vector2d& b) { return a.y() < b.y(); });
    const ReferenceCircles after = fitCircles(moved);
    for (const auto kind : kinds) {
        const FittedCircle &a = before.of(kind), &b = after.of(kind);
        if (!a.unique || !b.unique) continue;  // the value agrees, the centre need not
        RC_ASSERT(std::abs(b.RONt_um / scale - a.RONt_um) < 1e-5);
        RC_ASSERT(std::abs(b.radius_mm / scale - a.radius_mm) < 1e-8);
    }
}

/// The largest circle whose centre is in the hull of points that surround the origin, by trying all: it touches three
/// points, or two with its centre on the hull, or one with its centre in a corner.
double inscribedByBruteForce(const Points& points)
{
    const auto cross = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
    std::vector<std::pair<Vector2d, Vector2d>> edges;  // of the hull, anticlockwise
    for (const Vector2d& a : points)
        for (const Vector2d& b : points) {
            if (a == b) continue;
            bool all = true;
            for (const Vector2d& c : points) all = all && cross(b - a, c - a) >= -1e-12;
            if (all) edges.emplace_back(a, b);
        }
    double best = 0;
    const auto consider = [&](const Vector2d& centre) {
        for (const auto& [a, b] : edges)
            if (cross(b - a, centre - a) < -1e-9) return;
        best = std::max(best, innerRadiusAbout(points, centre));
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const Vector2d along = points[j] - points[i], middle = 0.5 * (points[i] + points[j]);
            for (const auto& [a, b] : edges)  // the bisector meets the edge
                if (const double slope = along.dot(b - a); std::abs(slope) > 1e-12)
                    if (const double t = along.dot(middle - a) / slope; t >= 0 && t <= 1) consider(a + t * (b - a));
            for (std::size_t k = j + 1; k < points.size(); ++k) {
                const Vector2d u = along, v = points[k] - points[i];
                const double area = 2 * cross(u, v);
                if (std::abs(area) < 1e-12) continue;
                consider(points[i] + Vector2d(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                                              u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                                         area);
            }
        }
    return best;
}

TEST(CirclesProperty, InscribedEqualsBruteForce)
{
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Points points = scattered(seed, 12 + seed % 20, seed % 2 ? 0.5 : 0.1);
        const ReferenceCircles circles = fitCircles(points);
        if (circles.LSCI.centre_mm.norm() > 0.3) continue;  // keep those that surround it
        ++compared;
        EXPECT_NEAR(circles.MICI.radius_mm, inscribedByBruteForce(points), 2e-8) << seed;
    }
    EXPECT_GT(compared, 40);
}

/// The narrowest zone: 2 + 2 contacts on two bisectors, or 3 + 1 / 1 + 3 about a circumcentre.
double zoneByBruteForce(const Points& points)
{
    const auto cross = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
    double best = std::numeric_limits<double>::infinity();
    std::vector<std::pair<Vector2d, Vector2d>> bisectors;  // middle, normal
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            bisectors.emplace_back(0.5 * (points[i] + points[j]), points[j] - points[i]);
    for (std::size_t i = 0; i < bisectors.size(); ++i)
        for (std::size_t j = i + 1; j < bisectors.size(); ++j) {
            const auto& [p, n] = bisectors[i];
            const auto& [q, m] = bisectors[j];
            const double area = cross(n, m);
            if (std::abs(area) < 1e-12) continue;
            const double a = n.dot(p), b = m.dot(q);
            const Vector2d centre((a * m.y() - b * n.y()) / area, (b * n.x() - a * m.x()) / area);
            if (centre.norm() < 2) best = std::min(best, zoneAbout(points, centre));
        }
    return best;
}

TEST(CirclesProperty, MinimumZoneEqualsBruteForceAtHalfTheRadiusOfSpread)
{
    for (std::uint64_t seed = 100; seed < 160; ++seed) {
        const Points points = scattered(seed, 5 + seed % 16, seed % 3 ? 0.5 : 0.05);
        EXPECT_NEAR(fitCircles(points).MZCI.RONt_um / 1000, zoneByBruteForce(points), 2e-8) << seed;
    }
}

}  // namespace
}  // namespace lathelier::form
