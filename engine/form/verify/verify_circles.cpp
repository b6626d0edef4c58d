#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numbers>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/form/circle/circles.h"
#include "engine/form/verify/form_verification.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

using std::numbers::pi;

/// A profile with known reference circles.
struct KnownProfile {
    Points points;
    Vector2d centre = Vector2d::Zero();
    double inner_mm = 0;  ///< radius of MICI
    double outer_mm = 0;  ///< radius of MCCI; MZCI is the zone between the two
};

template <class Radius>
KnownProfile profile(std::size_t count, Radius radius, double inner_mm, double outer_mm, const Vector2d& centre)
{
    KnownProfile known{{}, centre, inner_mm, outer_mm};
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
        known.points.push_back(centre + radius(t) * Vector2d(std::cos(t), std::sin(t)));
    }
    return known;
}

/// Profiles whose symmetry makes all circles concentric and whose extremes are among the points.
std::vector<KnownProfile> symmetricProfiles()
{
    std::vector<KnownProfile> all;
    for (const int lobes : {3, 4, 5, 7, 15}) {
        const auto radius = [lobes](double t) { return 25 + 0.003 * std::cos(lobes * t); };
        all.push_back(profile(60 * static_cast<std::size_t>(lobes), radius, 24.997, 25.003, {0.04, -0.03}));
    }
    const auto squares = [](double t) { return std::lround(t / (pi / 4)) % 2 == 0 ? 10 : 9.9; };
    all.push_back(profile(8, squares, 9.9, 10, {1, 2}));
    // Reuleaux triangle of width 40: three arcs of radius 40 about the opposite corners.
    const double corner = 40 / std::sqrt(3.0);
    const auto reuleaux = [corner](double t) {
        const double third = 2 * pi / 3, middle = pi / 3;  // a corner at 0, the middle of an arc at 60°
        const double off = std::fmod(t, third) - middle;
        // The ray from the centre meets the circle of radius 40 about the corner opposite the arc.
        return -corner * std::cos(off) + std::sqrt(1600 - corner * corner * std::sin(off) * std::sin(off));
    };
    all.push_back(profile(360, reuleaux, 40 - corner, corner, {-5, 7}));
    return all;
}

/// Points about `centre` at `radius` with deviations of amplitude `deviation` orthogonal to the circle parameters,
/// which leave the least-squares circle unchanged.
Points leastSquaresKnown(std::uint64_t seed, std::size_t count, double turn, double radius, double deviation,
                         const Vector2d& centre)
{
    const auto n = static_cast<Eigen::Index>(count);
    Eigen::MatrixX3d basis(n, 3);
    Eigen::VectorXd e(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double t = 0.3 + turn * static_cast<double>(i) / static_cast<double>(count);
        basis.row(i) << 1, std::cos(t), std::sin(t);
        e[i] = deviation * (2 * randomUniform(seed, 0, static_cast<std::uint64_t>(i)) - 1);
    }
    for (int twice = 0; twice < 2; ++twice)
        e -= basis * (basis.transpose() * basis).ldlt().solve(basis.transpose() * e);
    Points points;
    for (Eigen::Index i = 0; i < n; ++i)
        points.push_back(centre + (radius + e[i]) * Vector2d(basis(i, 1), basis(i, 2)));
    return points;
}

Points scattered(std::uint64_t seed, std::size_t count)
{
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 2 * pi * randomUniform(seed, 0, i), r = 0.75 + 0.5 * randomUniform(seed, 1, i);
        points.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    return points;
}

/// The narrowest zone of few points by trying every centre where two pairs of points are equally far away: an optimum
/// has two and two contacts, or three and one.
double zoneByEnumeration(const Points& points)
{
    std::vector<std::pair<Vector2d, double>> bisectors;  // normal · c = offset
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const Vector2d normal = points[j] - points[i];
            bisectors.emplace_back(normal, 0.5 * normal.dot(points[i] + points[j]));
        }
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bisectors.size(); ++i)
        for (std::size_t j = i + 1; j < bisectors.size(); ++j) {
            const auto& [n, a] = bisectors[i];
            const auto& [m, b] = bisectors[j];
            const double area = n.x() * m.y() - n.y() * m.x();
            if (std::abs(area) < 1e-9) continue;
            const Vector2d centre((a * m.y() - b * n.y()) / area, (b * n.x() - a * m.x()) / area);
            if (centre.norm() > 2) continue;
            double low = std::numeric_limits<double>::infinity(), high = 0;
            for (const Vector2d& point : points) {
                const double d = (point - centre).norm();
                low = std::min(low, d);
                high = std::max(high, d);
            }
            best = std::min(best, high - low);
        }
    return best;
}

}  // namespace

VerifyKind verifyLeastSquaresCircles()
{
    VerifyTally tally("least_squares_circle", LT_TEXT("Engine", "Least-squares circle"), unit::mm, answerLimit_mm);
    const double radius = 25;
    std::uint64_t seed = 0;
    for (const double turn : {2 * pi, pi, pi / 2})
        for (const double deviation : {0.0, 0.005})
            for (const Vector2d& centre : {Vector2d(0.03, -0.04), Vector2d(1e3 * radius, -0.6e3 * radius)}) {
                const Points points = leastSquaresKnown(++seed, 200, turn, radius, deviation, centre);
                const FittedCircle circle = fitLeastSquaresCircle(points);
                tally.nextSet();
                tally.take((circle.centre_mm - centre).norm());
                tally.compare(circle.radius_mm, radius);
            }
    for (const KnownProfile& known : symmetricProfiles()) {
        const FittedCircle circle = fitLeastSquaresCircle(known.points);
        tally.nextSet();
        tally.take((circle.centre_mm - known.centre).norm());
        tally.compare(circle.RONt_um / 1000, known.outer_mm - known.inner_mm);
    }
    return tally.done();
}

VerifyKind verifyMinimumZoneCircles()
{
    VerifyTally tally("minimum_zone_circle", LT_TEXT("Engine", "Minimum-zone circle"), unit::mm, answerLimit_mm);
    for (const KnownProfile& known : symmetricProfiles()) {
        const FittedCircle circle = fitCircles(known.points).MZCI;
        tally.nextSet();
        tally.compare(circle.RONt_um / 1000, known.outer_mm - known.inner_mm);
        tally.compare(circle.inner_radius_mm, known.inner_mm);
        tally.compare(circle.outer_radius_mm, known.outer_mm);
    }
    // An ellipse: the zone between its half axes.
    const auto ellipse = [](double t) { return 10 * 9.95 / std::hypot(9.95 * std::cos(t), 10 * std::sin(t)); };
    tally.nextSet();
    tally.compare(fitCircles(profile(400, ellipse, 9.95, 10, {3, 3}).points).MZCI.RONt_um / 1000, 0.05);
    return tally.done();
}

VerifyKind verifyInscribedCircles()
{
    VerifyTally tally("inscribed_circle", LT_TEXT("Engine", "Maximum inscribed circle"), unit::mm, answerLimit_mm);
    for (const KnownProfile& known : symmetricProfiles()) {
        tally.nextSet();
        tally.compare(fitCircles(known.points).MICI.radius_mm, known.inner_mm);
    }
    return tally.done();
}

VerifyKind verifyCircumscribedCircles()
{
    VerifyTally tally("circumscribed_circle", LT_TEXT("Engine", "Minimum circumscribed circle"), unit::mm,
                      answerLimit_mm);
    for (const KnownProfile& known : symmetricProfiles()) {
        tally.nextSet();
        tally.compare(fitCircles(known.points).MCCI.radius_mm, known.outer_mm);
    }
    return tally.done();
}

VerifyKind verifyScatteredZones(const Progress& progress)
{
    // The certificate's own tolerance is a hundred-millionth of the zone.
    VerifyTally tally("scattered_points", LT_TEXT("Engine", "Minimum zone of scattered points, by enumeration"),
                      unit::mm, 1e-8);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        progress.check();
        const Points points = scattered(seed, 8 + seed % 6);
        tally.nextSet();
        tally.compare(fitCircles(points).MZCI.RONt_um / 1000, zoneByEnumeration(points));
    }
    return tally.done();
}

VerifyKind verifyCertificates(const Progress& progress)
{
    VerifyTally tally("certified_gap", LT_TEXT("Engine", "Gap certified for minimum zone and inscribed circle"),
                      unit::um, 2e-6);
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        progress.check();
        const auto turned = [&](double t) {
            const auto place = static_cast<std::uint64_t>(std::lround(t * 1e6));
            return 25 + 0.003 * std::cos(2 * t + 0.4) + 0.002 * std::cos(3 * t) + 0.0008 * randomNormal(seed, 3, place);
        };
        const ReferenceCircles circles = fitCircles(profile(seed % 2 ? 3600 : 200, turned, 0, 0, {0.03, 0.04}).points);
        tally.nextSet();
        tally.take(circles.MZCI.certified_gap_um.value_or(std::nan("")));
        tally.take(circles.MICI.certified_gap_um.value_or(std::nan("")));
        // The zone is never wider than another circle's.
        tally.take(
            std::max({0.0, circles.MZCI.RONt_um - circles.LSCI.RONt_um, circles.MZCI.RONt_um - circles.MICI.RONt_um,
                      circles.MZCI.RONt_um - circles.MCCI.RONt_um}));
    }
    return tally.done();
}

}  // namespace lathelier::form
