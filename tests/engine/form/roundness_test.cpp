#include "engine/form/roundness/roundness.h"

#include "engine/core/core_codes.h"
#include "engine/form/form_codes.h"
#include "engine/form/roundness/roundness_quantities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/io/io_codes.h"
#include "tests/engine/form/exact_points.h"
#include "tests/engine/form/made_profile.h"

namespace lathelier::form {
namespace {

using std::numbers::pi;

TEST(Roundness, ALobedProfileHasTwiceItsAmplitude)
{
    // Closed form: with k ≥ 2 lobes that touch at 2k places the minimum zone is centred, RONt = 2 a.
    for (const int k : {2, 3, 4, 5, 7, 15}) {
        const RoundnessResult result = roundness(lobedProfile(evenAngles(3600), {{k, .003, .4}}, {3, -2}), exact());
        EXPECT_NEAR(result.circles.LSCI.RONt_um, 6, 3e-3) << k;
        EXPECT_NEAR(result.circles.MZCI.RONt_um, 6, 3e-3) << k;
        const signal::Harmonic& h = result.harmonics.at(static_cast<std::size_t>(k) - 1);
        EXPECT_NEAR(h.amplitude, 3, 3e-3);
        EXPECT_NEAR(std::remainder(h.phase_rad - .4, 2 * pi), 0, 1e-3);
        EXPECT_EQ(result.evaluated_mm.size(), 3600u);
    }
}

TEST(Roundness, WithoutAFilterThePointsAreUntouched)
{
    const Profile profile = lobedProfile(evenAngles(360), {{2, .005, 0}}, {1, 2}, .0005);
    const RoundnessResult result = roundness(profile);
    for (std::size_t i = 0; i < result.evaluated_mm.size(); ++i)
        EXPECT_EQ(result.evaluated_mm[i], profile.points_mm[result.evaluated_index[i]]);
    const ReferenceCircles circles = fitCircles(profile.points_mm);
    EXPECT_DOUBLE_EQ(result.circles.MZCI.RONt_um, circles.MZCI.RONt_um);
    EXPECT_EQ(result.circles.MZCI.contacts, circles.MZCI.contacts);
}

TEST(Roundness, AnEllipse)
{
    const double a = 25.006, b = 24.994;
    Profile profile;
    for (const double t : evenAngles(3600)) profile.points_mm.emplace_back(a * std::cos(t), b * std::sin(t));
    const RoundnessResult result = roundness(profile, exact());
    EXPECT_NEAR(result.circles.LSCI.RONt_um, 12, 1e-6);
    EXPECT_NEAR(result.circles.MZCI.RONt_um, 12, 1e-6);
    EXPECT_NEAR(result.two_point.range_um, 24, 1e-4);
    EXPECT_NEAR(result.two_point.caliper_largest_mm, 2 * a, 1e-9);
    EXPECT_NEAR(result.two_point.caliper_smallest_mm, 2 * b, 1e-4);
    ASSERT_FALSE(result.hints.empty());
    EXPECT_EQ(result.hints[0].upr, 2);
    EXPECT_GT(result.hints[0].share_percent, 99);
}

/// Reuleaux triangle of width `width`: arcs about the corners.
Profile reuleaux(double width, std::size_t points)
{
    Profile profile;
    for (std::size_t i = 0; i < points; ++i) {
        const double share = 3 * static_cast<double>(i) / static_cast<double>(points);
        const double corner = std::floor(share);
        const double from = (corner * 120 + 180 - 30) * pi / 180;
        const double angle = from + (share - corner) * pi / 3;
        const double at = corner * 2 * pi / 3;
        const double out = width / std::sqrt(3.0);
        profile.points_mm.emplace_back(out * std::cos(at) + width * std::cos(angle),
                                       out * std::sin(at) + width * std::sin(angle));
    }
    return profile;
}

TEST(Roundness, ReuleauxTriangleOfConstantWidth)
{
    // Ro - Ri = w/√3 - (w - w/√3) = w (2/√3 - 1): 6.188021535 for w = 40 mm; every caliper finds 40 mm.
    const RoundnessResult result = roundness(reuleaux(40, 3600), exact());
    EXPECT_NEAR(result.circles.MZCI.RONt_um, 6188.021536, 1e-2);
    EXPECT_NEAR(result.two_point.caliper_largest_mm, 40, 1e-9);
    EXPECT_NEAR(result.two_point.caliper_smallest_mm, 40, 1e-4);
    EXPECT_EQ(result.hints.at(0).upr, 3);
}

TEST(PaperTraps, RunOutOfAPerfectCircleIsNotRoundness)
{
    // Trap 1: an eccentricity of 50 µm gives a run-out of 100 µm on a perfect circle.
    const RoundnessResult result = roundness(lobedProfile(evenAngles(3600), {}, {.03, .04}), exact());
    EXPECT_NEAR(result.paper.run_out_um, 100, 1e-3);
    EXPECT_LT(result.circles.MZCI.RONt_um, 1e-6);
    EXPECT_NEAR(result.hints.back().amplitude_um, 50, 1e-6);
    EXPECT_EQ(result.hints.back().upr, 1);
}

TEST(PaperTraps, TheLimaconCentreIsRightOnlyAtUniformPolarAngles)
{
    // Trap 2: at uniform polar angles about the origin it is the centre; about the circle's own centre it is half
    // wrong.
    Profile polar;
    const Eigen::Vector2d centre(.03, .04);
    for (const double angle : evenAngles(200)) {
        const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
        const double along = u.dot(centre);
        polar.points_mm.push_back(u * (along + std::sqrt(625 - centre.squaredNorm() + along * along)));
    }
    const RoundnessResult right = roundness(polar, exact());
    EXPECT_NEAR(right.paper.limacon_centre_um.x(), 30, 1e-3);
    EXPECT_NEAR(right.paper.limacon_centre_um.y(), 40, 1e-3);
    // A missing sample moves the paper's centre of the radii themselves by 0.25 mm at R = 25; the fitted one stays.
    Profile missing = polar;
    missing.points_mm.erase(missing.points_mm.begin());
    Eigen::Vector2d paper = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : missing.points_mm) paper += 2 * point / 199.;
    EXPECT_GT((paper - centre).norm(), .2);
    EXPECT_NEAR((roundness(missing, exact()).circles.LSCI.centre_mm - centre).norm(), 0, 1e-9);
    // Large eccentricity: always about the fitted centre.
    EXPECT_NEAR(roundness(lobedProfile(evenAngles(360), {{3, .005, 0}}, {20, 5}), exact()).circles.MZCI.RONt_um, 10,
                1e-3);
    EXPECT_NEAR(roundness(lobedProfile(evenAngles(360), {{3, .005, 0}}, {20000, 5}), exact()).circles.MZCI.RONt_um, 10,
                1e-3);
}

TEST(PaperTraps, TwoPointSizeIsBlindToOddLobes)
{
    // Trap 3, for even and odd numbers of points and uneven angles.
    for (const std::size_t n : {200u, 201u, 3599u}) {
        const RoundnessResult result = roundness(lobedProfile(evenAngles(n), {{3, .005, .2}}), exact());
        EXPECT_NEAR(result.circles.MZCI.RONt_um, 10, .01);
        EXPECT_NEAR(result.two_point.range_um, 0, .002) << n;
        const TwoPointSize oval = roundness(lobedProfile(evenAngles(n), {{2, .005, .2}}), exact()).two_point;
        EXPECT_NEAR(oval.range_um, 20, .01) << n;
        EXPECT_NEAR(oval.half_range_um, 10, .005) << n;
        EXPECT_NEAR(oval.largest_mm, 50.01, 1e-5) << n;
    }
    std::vector<double> angle = evenAngles(500);
    for (std::size_t i = 0; i < angle.size(); ++i) angle[i] += .004 * randomUniform(4, 0, i);
    EXPECT_NEAR(roundness(lobedProfile(angle, {{3, .005, .2}}), exact()).two_point.range_um, 0, .002);
}

TEST(Roundness, TheFilterDampsTheLobes)
{
    const Profile profile = lobedProfile(evenAngles(3600), {{5, .003, 0}, {40, .001, 1}}, {.02, .01});
    RoundnessParameters parameters = exact();
    parameters.cutoff_upr = 15;
    const RoundnessResult result = roundness(profile, parameters);
    // 5 UPR pass by 0.9259, 40 UPR by 0.7 %.
    const double remaining = 2 * signal::gaussianTransmission(40, 15);
    EXPECT_NEAR(result.circles.LSCI.RONt_um, 6 * signal::gaussianTransmission(5, 15), remaining);
    EXPECT_NEAR(result.harmonics[39].amplitude, 1, 1e-4);  // of the unfiltered profile
    parameters.cutoff_upr.reset();
    parameters.band_upr = {{15, 500}};
    const double passed = 2 * (1 - signal::gaussianTransmission(40, 15)) * signal::gaussianTransmission(40, 500);
    const double rest = 6 * (1 - signal::gaussianTransmission(5, 15));
    EXPECT_NEAR(roundness(profile, parameters).circles.LSCI.RONt_um, passed + rest, .02 * (passed + rest));
}

TEST(Roundness, ContactsAndExclusionsCountGivenPoints)
{
    const Eigen::Vector2d centre(100, 50);
    Profile profile = lobedProfile(evenAngles(720), {{2, .005, 0}}, centre);
    for (std::size_t i = 715; i < 726; ++i) {  // a keyway that runs through 0°
        Eigen::Vector2d& point = profile.points_mm[i % 720];
        point = centre + .9 * (point - centre);
    }
    RoundnessParameters parameters = exact();
    parameters.exclude_deg = {{356, 4}};
    const RoundnessResult result = roundness(profile, parameters);
    EXPECT_NEAR(result.circles.MZCI.RONt_um, 10, .05);
    EXPECT_TRUE(contains(result.notes, notes::sectorsExcluded));
    EXPECT_TRUE(contains(result.notes, notes::gapsInProfile));
    EXPECT_FALSE(result.used[0]);
    EXPECT_FALSE(result.used[716]);
    EXPECT_TRUE(result.used[360]);
    ASSERT_GE(result.circles.MZCI.contacts.size(), 4u);
    const FittedCircle& zone = result.circles.MZCI;
    for (const CircleContact& contact : zone.contacts) {
        EXPECT_TRUE(result.used[contact.index]);
        const double distance = (profile.points_mm[contact.index] - zone.centre_mm).norm();
        EXPECT_NEAR(distance, contact.side == CircleContact::Side::Outer ? zone.outer_radius_mm : zone.inner_radius_mm,
                    1e-9);
    }
}

TEST(Roundness, AKeywayDoesNotRingThroughTheFilter)
{
    const std::vector<Lobe> lobes{{2, .005, 1}, {3, .002, 0}, {60, .0005, 0}};
    const double whole = roundness(lobedProfile(evenAngles(3600), lobes),
                                   [] {
                                       RoundnessParameters p = exact();
                                       p.cutoff_upr = 50;
                                       return p;
                                   }())
                             .circles.MZCI.RONt_um;
    Profile profile = lobedProfile(evenAngles(3600), lobes);
    for (std::size_t i = 1000; i < 1080; ++i) profile.points_mm[i] *= 21. / 25;  // 4 mm deep, 8° wide
    RoundnessParameters parameters = exact();
    parameters.cutoff_upr = 50;
    parameters.exclude_deg = {{99.9, 108.1}};
    const RoundnessResult result = roundness(profile, parameters);
    EXPECT_EQ(result.filter_method, signal::FilterMethod::Regression);
    EXPECT_NEAR(result.circles.MZCI.RONt_um, whole, .03 * whole);
}

TEST(Roundness, OutliersAreLeftOutWhenAsked)
{
    Profile profile = lobedProfile(evenAngles(400), {{2, .004, 1}}, {.05, 0}, .0003);
    profile.points_mm[37] *= 25.03 / 25;
    profile.points_mm[151] *= 24.97 / 25;
    EXPECT_GT(roundness(profile).circles.MZCI.RONt_um, 30);
    RoundnessParameters parameters;
    parameters.outliers = OutlierRule::Hampel;
    const RoundnessResult result = roundness(profile, parameters);
    EXPECT_NEAR(result.circles.MZCI.RONt_um, 9, 1.2);
    EXPECT_FALSE(result.used[37]);
    EXPECT_FALSE(result.used[151]);
    EXPECT_EQ(std::count(result.used.begin(), result.used.end(), 0), 2);
    EXPECT_TRUE(contains(result.notes, notes::outliersRemoved));
}

TEST(Roundness, SaysWhatThePointsAreLike)
{
    RoundnessParameters parameters = exact();
    parameters.cutoff_upr = 50;
    Profile profile = lobedProfile(evenAngles(200), {{2, .004, 1}});
    const RoundnessResult result = roundness(profile, parameters);
    ASSERT_TRUE(contains(result.notes, notes::undersampled));
    for (const Note& note : result.notes)
        if (note.code == notes::undersampled) {
            EXPECT_EQ(std::get<double>(*find(note.values, "supported_upr")), 15);
            EXPECT_EQ(std::get<std::int64_t>(*find(note.values, "points")), 200);
        }
    parameters.cutoff_upr = 15;
    EXPECT_FALSE(contains(roundness(profile, parameters).notes, notes::undersampled));
    profile.points_mm.push_back(profile.points_mm.front());
    EXPECT_TRUE(contains(roundness(profile, parameters).notes, notes::duplicatePoints));
    profile.size_is_nominal = true;
    EXPECT_TRUE(contains(roundness(profile, parameters).notes, notes::sizeNominal));
    std::vector<double> arc = evenAngles(400);
    arc.resize(150);
    const RoundnessResult part = roundness(lobedProfile(arc, {}), parameters);
    EXPECT_TRUE(contains(part.notes, notes::partialArc));
    EXPECT_TRUE(part.harmonics.empty());
    EXPECT_TRUE(std::isnan(part.two_point.range_um));
}

TEST(Roundness, TheMethodTableHoldsTheResultItself)
{
    const Profile profile = lobedProfile(evenAngles(400), {{2, .004, 1}, {30, .001, 0}}, {0, 0}, .0002);
    RoundnessParameters parameters;
    parameters.cutoff_upr = 50;
    const RoundnessResult result = roundness(profile, parameters);
    ASSERT_EQ(result.methods.size(), 8u);  // none, 15, 50, 150 (undersampled); with and without outliers
    EXPECT_EQ(result.methods[2].band, bandOf(parameters));
    EXPECT_EQ(result.methods[2].RONt_um[1], result.circles.MZCI.RONt_um);
    EXPECT_FALSE(result.methods[2].undersampled);
    EXPECT_TRUE(result.methods[3].undersampled);
    for (const MethodRow& row : result.methods)
        for (const double RONt_um : row.RONt_um) EXPECT_GE(RONt_um, row.RONt_um[1] - 1e-6);
    EXPECT_LT(result.methods[1].RONt_um[1], result.methods[0].RONt_um[1]);
}

TEST(Roundness, WithoutTheMethodTableAllElseIsTheSame)
{
    const Profile profile = lobedProfile(evenAngles(400), {{2, .004, 1}, {30, .001, 0}}, {0, 0}, .0002);
    RoundnessParameters parameters;
    parameters.cutoff_upr = 50;
    parameters.tolerance_um = 9;
    Json whole = toJson(roundness(profile, parameters));
    const Json less = toJson(roundness(profile, parameters, {}, MethodTable::LeftOut));
    EXPECT_EQ(whole["methods"].size(), 8U);
    whole["methods"] = Json::array();
    EXPECT_EQ(whole, less);
}

TEST(Roundness, DecidesByTheRule)
{
    const Profile profile = lobedProfile(evenAngles(400), {{2, .004, 1}}, {0, 0}, .0002);
    RoundnessParameters parameters;
    EXPECT_FALSE(roundness(profile).verdict);
    const RoundnessResult measured = roundness(profile);
    const double value = headlineDeviation_um(measured), u = measured.RONt_expanded_uncertainty_um;
    const auto verdict = [&](double tolerance, DecisionRule rule) {
        parameters.tolerance_um = tolerance;
        parameters.decision = rule;
        return *roundness(profile, parameters).verdict;
    };
    EXPECT_EQ(verdict(value * 1.0001, DecisionRule::Simple), Verdict::Pass);
    EXPECT_EQ(verdict(value * .9999, DecisionRule::Simple), Verdict::Fail);
    EXPECT_EQ(verdict(value + .9 * u, DecisionRule::Guarded), Verdict::Undecided);
    EXPECT_EQ(verdict(value - .9 * u, DecisionRule::Guarded), Verdict::Undecided);
    EXPECT_EQ(verdict(value + 1.1 * u, DecisionRule::Guarded), Verdict::Pass);
    EXPECT_EQ(verdict(value - 1.1 * u, DecisionRule::Guarded), Verdict::Fail);
}

TEST(Roundness, RefusesWhatHasNoAnswer)
{
    const auto code = [](const Profile& profile, const RoundnessParameters& parameters = {}) {
        try {
            roundness(profile, parameters);
        } catch (const Error& error) {
            return error.code();
        }
        return errors::internal;
    };
    Profile profile;
    EXPECT_EQ(code(profile), errors::tooFewPoints);
    profile.points_mm = {{1, 0}, {0, 1}, {-1, 0}};
    EXPECT_EQ(code(profile), errors::tooFewPoints);
    profile.points_mm.emplace_back(notANumber, 0);
    EXPECT_EQ(code(profile), errors::tooFewPoints);
    profile.points_mm.assign(10, {1, 1});
    EXPECT_NE(code(profile), errors::internal);
    profile.points_mm.clear();
    for (int i = 0; i < 10; ++i) profile.points_mm.emplace_back(i, 2 * i);
    EXPECT_EQ(code(profile), errors::pointsDegenerate);
    RoundnessParameters parameters;
    parameters.exclude_deg = {{0, 360}};
    EXPECT_EQ(code(lobedProfile(evenAngles(100), {}), parameters), errors::tooFewPoints);
    parameters = {};
    parameters.cutoff_upr = 50;
    parameters.band_upr = {{15, 500}};
    EXPECT_EQ(code(lobedProfile(evenAngles(100), {}), parameters), errors::valueNotUnderstood);
    Profile holed = lobedProfile(evenAngles(100), {});
    holed.points_mm[7] = {notANumber, 1};
    const RoundnessResult result = roundness(holed);
    EXPECT_TRUE(contains(result.notes, notes::pointsNotFinite));
    EXPECT_FALSE(result.used[7]);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(roundness(lobedProfile(evenAngles(100), {}), {}, Progress(stop.get_token(), {})), Cancelled);
}

TEST(Roundness, FourPointsHaveOneAnswerWithAndWithoutTheTableOfMethods)
{
    Profile profile;
    profile.points_mm = {{0, 0}, {.5, .01}, {1, 0}, {.5, -.02}};
    for (const MethodTable table : {MethodTable::Made, MethodTable::LeftOut}) {
        const RoundnessResult result = roundness(profile, {}, {}, table);
        EXPECT_NEAR(result.circles.MCCI.centre_mm.x(), .5, 1e-9);
        EXPECT_NEAR(result.circles.MCCI.centre_mm.y(), 0, 1e-9);
        EXPECT_NEAR(result.circles.MCCI.radius_mm, .5, 1e-9);
    }
}

}  // namespace
}  // namespace lathelier::form
