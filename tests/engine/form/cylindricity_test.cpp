#include "engine/form/cylinder/cylindricity.h"
#include "engine/core/core_codes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "engine/core/random.h"
#include "engine/form/circle/circles.h"
#include "engine/form/form_codes.h"
#include "tests/engine/core/code_of_error.h"

namespace lathelier::form {
namespace {

using Eigen::Vector3d;

/// `deviation(angle, u)` in mm on a cylinder of radius and length, u from -1 to 1, at random places.
template <class Deviation>
std::vector<Vector3d> cylinder(std::size_t count, double radius, double length, Deviation deviation,
                               double turn = 2 * std::numbers::pi)
{
    std::vector<Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = turn * randomUniform(7, 0, i), u = 2 * randomUniform(7, 1, i) - 1;
        const double r = radius + deviation(t, u);
        points.emplace_back(r * std::cos(t), r * std::sin(t), u * length / 2);
    }
    return points;
}

template <class Deviation>
std::vector<Vector3d> stack(int sections, int angles, double radius, double length, Deviation deviation)
{
    std::vector<Vector3d> points;
    for (int s = 0; s < sections; ++s)
        for (int i = 0; i < angles; ++i) {
            const double t = 2 * std::numbers::pi * i / angles, u = 2.0 * s / (sections - 1) - 1;
            const double r = radius + deviation(t, u);
            points.emplace_back(r * std::cos(t), r * std::sin(t), (u + 1) * length / 2);
        }
    return points;
}

Eigen::Isometry3d pose(int k)
{
    const double a = 0.7 * k;
    return Eigen::Translation3d(100 * k, -30, 20 * k) *
           Eigen::AngleAxisd(a, Vector3d(std::sin(1.0 * k), 1, std::cos(2.0 * k)).normalized()) *
           Eigen::Isometry3d::Identity();
}

std::vector<Vector3d> movedPoints(const std::vector<Vector3d>& points, const Eigen::Isometry3d& motion)
{
    std::vector<Vector3d> result;
    for (const Vector3d& point : points) result.push_back(motion * point);
    return result;
}

const auto perfect = [](double, double) { return 0.0; };

TEST(Cylindricity, OfAPerfectCylinderInAnyPoseIsZero)
{
    for (const double length : {1.0, 10.0, 100.0, 2000.0})
        for (const double turn : {6.2832, 3.0, 1.0})
            for (int k = 0; k < 6; ++k) {
                SCOPED_TRACE(testing::Message() << "length " << length << " turn " << turn << " pose " << k);
                const Eigen::Isometry3d at = pose(k);
                const CylindricityResult result =
                    cylindricity(movedPoints(cylinder(500, 25, length, perfect, turn), at));
                EXPECT_NEAR(result.LSCY.radius_mm, 25, 1e-7);
                EXPECT_NEAR(result.LSCY.CYLt_um, 0, 1e-5);
                EXPECT_LE(result.MZCY.CYLt_um, result.LSCY.CYLt_um);
                const Vector3d axis = at.linear() * Vector3d::UnitZ();
                EXPECT_NEAR(std::abs(result.LSCY.axis_direction.dot(axis)), 1, 1e-12);
                const Vector3d off = result.LSCY.axis_point_mm - at.translation();
                EXPECT_NEAR((off - axis * axis.dot(off)).norm(), 0, 1e-7);
                EXPECT_NEAR(result.length_mm, length, 0.02 * length);
            }
}

TEST(Cylindricity, OfLobesTaperAndBowIsTheClosedForm)
{
    // 3 lobes of 4 µm: no axis does better.
    const auto lobes = [](double t, double) { return 0.004 * std::cos(3 * t); };
    const CylindricityResult lobed = cylindricity(movedPoints(stack(11, 120, 25, 80, lobes), pose(2)));
    EXPECT_NEAR(lobed.MZCY.CYLt_um, 8, 1e-6);
    EXPECT_NEAR(lobed.LSCY.CYLt_um, 8, 1e-6);
    EXPECT_NEAR(lobed.LSCY.CYLq_um, 4 / std::sqrt(2.0), 1e-4);
    EXPECT_NEAR(lobed.MZCY.radius_mm, 25, 1e-8);
    // To the last digits, wherever the search begins.
    for (int k = 0; k < 8; ++k)
        EXPECT_NEAR(cylindricity(movedPoints(stack(11, 60, 25, 80, lobes), pose(k))).LSCY.radius_mm, 25, 1e-11) << k;
    // Taper: 5 µm on the radius.
    const CylindricityResult taper = cylindricity(stack(11, 90, 25, 80, [](double, double u) { return 0.0025 * u; }));
    EXPECT_NEAR(taper.MZCY.CYLt_um, 5, 1e-5);
    EXPECT_NEAR(taper.LSCY.CYLp_um, 2.5, 1e-5);
    EXPECT_EQ(taper.sections, 11U);
    EXPECT_NEAR(taper.axis_straightness_um, 0, 1e-6);
    // A bent axis: 6 µm of sagitta.
    const CylindricityResult bow =
        cylindricity(stack(21, 180, 25, 100, [](double t, double u) { return 0.006 * u * u * std::cos(t); }));
    EXPECT_NEAR(bow.axis_straightness_um, 6, 1e-3);
    EXPECT_LT(bow.MZCY.CYLt_um, 6.01);
}

TEST(Cylindricity, OfOneSectionRepeatedIsItsRoundness)
{
    const auto form = [](double t, double) {
        return 0.003 * std::cos(2 * t) + 0.002 * std::cos(5 * t + 1) + 0.001 * std::cos(13 * t + 2);
    };
    const CylindricityResult cyl = cylindricity(stack(9, 200, 25, 60, form));
    std::vector<Eigen::Vector2d> section;
    for (const Vector3d& point : stack(2, 200, 25, 60, form))
        if (point.z() == 0) section.emplace_back(point.head<2>());
    const ReferenceCircles circles = fitCircles(section);
    EXPECT_NEAR(cyl.MZCY.CYLt_um, circles.MZCI.RONt_um, 1e-5);
    EXPECT_NEAR(cyl.LSCY.CYLt_um, circles.LSCI.RONt_um, 1e-5);
}

RC_GTEST_PROP(CylindricityProperty, MinimumZoneIsNeverWorseAndNoAxisNearIsBetter, ())
{
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 100000);
    const double noise = std::pow(10.0, -*rc::gen::inRange(1, 6));
    const double length = std::pow(10.0, *rc::gen::inRange(0, 3));
    std::vector<Vector3d> points = cylinder(60 + seed % 200, 10, length,
                                            [&](double t, double u) { return noise * std::cos(40 * t + 30 * u * t); });
    points = movedPoints(points, pose(static_cast<int>(seed % 5)));
    const CylindricityResult result = cylindricity(points);
    RC_ASSERT(result.MZCY.CYLt_um <= result.LSCY.CYLt_um * (1 + 1e-12));
    RC_ASSERT(result.MZCY.contacts.size() >= 5U);
    const auto zone = [&](const Vector3d& at, const Vector3d& along) {
        double low = std::numeric_limits<double>::infinity(), high = 0;
        for (const Vector3d& point : points) {
            const double d = (point - at).cross(along).norm() / along.norm();
            low = std::min(low, d);
            high = std::max(high, d);
        }
        return 1000 * (high - low);
    };
    RC_ASSERT(std::abs(zone(result.MZCY.axis_point_mm, result.MZCY.axis_direction) - result.MZCY.CYLt_um) < 1e-7);
    for (std::uint64_t k = 0; k < 200; ++k) {
        const double step = 0.1 * noise * std::pow(10.0, -4 * randomUniform(seed, 9, k));
        const auto any = [&](std::uint64_t s) {
            return Vector3d(randomNormal(seed, s, 3 * k), randomNormal(seed, s, 3 * k + 1),
                            randomNormal(seed, s, 3 * k + 2));
        };
        RC_ASSERT(zone(result.MZCY.axis_point_mm + step * any(1),
                       result.MZCY.axis_direction + step / std::max(length, 1.0) * any(2)) >=
                  result.MZCY.CYLt_um - 1e-7);
    }
}

TEST(Cylindricity, IsTheSameInAnyPoseAndOrder)
{
    const auto form = [](double t, double u) { return 0.003 * std::cos(2 * t + u) + 0.002 * std::sin(9 * t * u); };
    std::vector<Vector3d> points = cylinder(2000, 12, 70, form);
    const CylindricityResult before = cylindricity(points);
    std::reverse(points.begin(), points.end());
    for (int k = 0; k < 5; ++k) {
        const CylindricityResult after = cylindricity(movedPoints(points, pose(k)));
        EXPECT_NEAR(after.LSCY.CYLt_um, before.LSCY.CYLt_um, 1e-6);
        EXPECT_NEAR(after.LSCY.radius_mm, before.LSCY.radius_mm, 1e-10);
        EXPECT_NEAR(after.MZCY.CYLt_um, before.MZCY.CYLt_um, 1e-6);
    }
}

TEST(Cylindricity, JudgesWithAndWithoutUncertainty)
{
    const auto points = stack(11, 120, 25, 80, [](double t, double) { return 0.004 * std::cos(3 * t); });
    CylindricityParameters parameters;
    EXPECT_FALSE(cylindricity(points).verdict);
    parameters.tolerance_um = 7.9;
    EXPECT_EQ(cylindricity(points, parameters).verdict, Verdict::Fail);
    parameters.tolerance_um = 8.1;
    EXPECT_EQ(cylindricity(points, parameters).verdict, Verdict::Pass);
    parameters.decision = DecisionRule::Guarded;
    EXPECT_THROW(cylindricity(points, parameters), Error);
    parameters.probe_uncertainty_um = 0.3;
    const CylindricityResult open = cylindricity(points, parameters);
    EXPECT_EQ(open.verdict, Verdict::Undecided);
    EXPECT_GT(open.CYLt_expanded_uncertainty_um, 0.3);
    // Noise of 0.3 µm on 1320 points: its extremes alone add up to 3.5 standard deviations on each side.
    EXPECT_LT(open.CYLt_expanded_uncertainty_um, 2.1);
    parameters.tolerance_um = 10.2;
    EXPECT_EQ(cylindricity(points, parameters).verdict, Verdict::Pass);
    parameters.tolerance_um = 5.8;
    EXPECT_EQ(cylindricity(points, parameters).verdict, Verdict::Fail);
}

TEST(Cylindricity, NoiseIsEstimatedWhereItIsNotStated)
{
    const auto barrel = [](double t, double u) { return .004 * std::cos(3 * t + 1) - .003 * u * u; };
    std::vector<Vector3d> points = cylinder(1500, 20, 60, barrel);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] += .001 * randomNormal(5, 0, i) * Vector3d(points[i].x() / 20, points[i].y() / 20, 0);
    CylindricityParameters parameters;
    const CylindricityResult silent = cylindricity(points);
    EXPECT_NEAR(silent.point_noise_um, 1, .1);
    EXPECT_GT(silent.CYLt_expanded_uncertainty_um, 2);
    EXPECT_FALSE(contains(silent.notes, notes::noiseEstimated));
    parameters.tolerance_um = silent.MZCY.CYLt_um - .5;
    CylindricityResult judged = cylindricity(points, parameters);
    EXPECT_EQ(judged.verdict, Verdict::Fail);
    EXPECT_TRUE(contains(judged.notes, notes::noiseEstimated));
    EXPECT_TRUE(contains(judged.notes, notes::failWithinUncertainty));
    parameters.decision = DecisionRule::GuardedRejection;
    judge(judged, parameters);
    EXPECT_EQ(judged.verdict, Verdict::Undecided);
    EXPECT_FALSE(contains(judged.notes, notes::failWithinUncertainty));
    // Few points do not tell noise and form apart: no uncertainty, and a note with the verdict.
    parameters.decision = DecisionRule::Simple;
    points.resize(200);
    const CylindricityResult few = cylindricity(points, parameters);
    EXPECT_TRUE(std::isnan(few.CYLt_expanded_uncertainty_um));
    EXPECT_TRUE(contains(few.notes, notes::noiseNotKnown));
    EXPECT_TRUE(std::isnan(cylindricity(points, {}, {}, NoiseEstimate::LeftOut).point_noise_um));
}

TEST(Cylindricity, TheStatedUncertaintyHoldsTheTruth)
{
    CylindricityParameters parameters;
    parameters.probe_uncertainty_um = .5;
    const auto barrel = [](double t, double u) { return .004 * std::cos(3 * t + 1) - .003 * u * u; };
    const auto round = [](double, double) { return 0.0; };
    for (const bool formed : {false, true})
        for (const std::size_t n : {400u, 3000u}) {
            const auto form = [&](double t, double u) { return formed ? barrel(t, u) : round(t, u); };
            const double truth = cylindricity(cylinder(n, 20, 60, form)).MZCY.CYLt_um;
            int covered = 0;
            double sum = 0, error = 0;
            constexpr int runs = 30;
            for (std::uint64_t run = 1; run <= runs; ++run) {
                std::vector<Vector3d> points = cylinder(n, 20, 60, form);
                for (std::size_t i = 0; i < n; ++i) {
                    const Vector3d outward(points[i].x() / 20, points[i].y() / 20, 0);
                    points[i] += .0005 * randomNormal(run, 0, i) * outward;
                }
                const CylindricityResult result = cylindricity(points, parameters);
                const double off = std::abs(result.MZCY.CYLt_um - truth);
                covered += off <= result.CYLt_expanded_uncertainty_um;
                sum += result.CYLt_expanded_uncertainty_um;
                error += off;
            }
            EXPECT_GE(covered, .86 * runs) << n << formed;
            EXPECT_LT(sum, 3 * error) << n << formed;
        }
}

ErrorCode cylinderRefusal(const std::vector<Vector3d>& points)
{
    return codeOfError([&] { cylindricity(points); });
}

TEST(Cylindricity, SaysWhyItHasNoAnswer)
{
    EXPECT_EQ(cylinderRefusal({}), errors::tooFewPoints);
    EXPECT_EQ(cylinderRefusal(std::vector<Vector3d>(5, Vector3d(1, 2, 3))), errors::tooFewPoints);
    EXPECT_EQ(cylinderRefusal(std::vector<Vector3d>(50, Vector3d(1, 2, 3))), errors::pointsDegenerate);
    std::vector<Vector3d> line, ring;
    for (int i = 0; i < 30; ++i) {
        line.emplace_back(i, 2.0 * i, 3.0 * i);
        ring.emplace_back(std::cos(0.2 * i), std::sin(0.2 * i), 5);
    }
    EXPECT_EQ(cylinderRefusal(line), errors::pointsDegenerate);
    EXPECT_EQ(cylinderRefusal(ring), errors::pointsDegenerate);
    ring[3].x() = std::nan("");
    EXPECT_EQ(cylinderRefusal(ring), errors::coordinateTooLarge);
}

TEST(Cylindricity, StopsWhenCancelled)
{
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(cylindricity(cylinder(1000, 10, 30, perfect), {}, Progress(source.get_token(), nullptr)), Cancelled);
}

}  // namespace
}  // namespace lathelier::form
