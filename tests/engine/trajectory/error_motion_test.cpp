#include "engine/trajectory/error_motion.h"
#include "engine/core/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/random.h"

namespace lathelier::trajectory {
namespace {

using std::numbers::pi;

std::vector<double> evenAngles(std::size_t n)
{
    std::vector<double> angle_deg(n);
    for (std::size_t i = 0; i < n; ++i) angle_deg[i] = 360 * static_cast<double>(i) / static_cast<double>(n);
    return angle_deg;
}

TEST(Student, QuantilesAreThoseOfTheTables)
{
    const struct {
        std::int64_t degrees;
        double quantile;
    } cases[] = {{1, 12.7062}, {2, 4.3027},  {3, 3.1824},  {4, 2.7764},  {5, 2.5706},
                 {7, 2.3646},  {10, 2.2281}, {19, 2.0930}, {39, 2.0227}, {1000, 1.9623}};
    for (const auto& [degrees, quantile] : cases)
        EXPECT_NEAR(studentQuantile(0.975, degrees), quantile, 6e-5) << degrees;
    EXPECT_TRUE(std::isnan(studentQuantile(0.975, 0)));
}

TEST(ErrorMotion, SettingAndEccentricityAreNoErrorMotion)
{
    const std::vector<double> angle_deg = evenAngles(200);
    std::vector<double> values;
    // Two lobes of 1.5 µm on an eccentricity of 12 µm; every other revolution lies 0.8 µm higher.
    for (int k = 0; k < 10; ++k)
        for (const double angle : angle_deg) {
            const double t = angle * pi / 180;
            values.push_back(7 + 12 * std::cos(t - 0.7) + 1.5 * std::cos(2 * t) + (k % 2 ? 0.8 : 0));
        }
    const ErrorMotion motion = errorMotion(values, angle_deg);
    EXPECT_NEAR(motion.synchronous_um, 3, 1e-9);
    EXPECT_NEAR(motion.asynchronous_um, 0.8, 1e-9);
    EXPECT_NEAR(motion.total_um, 3.8, 1e-9);
    EXPECT_NEAR(motion.synchronous_curve_um[0], 1.5, 1e-9);
}

/// Two lobes, and noise that is one value in each revolution and one at each reading.
std::vector<double> noisyTurns(std::uint64_t seed, std::size_t revolutions, const std::vector<double>& angle_deg)
{
    std::vector<double> values;
    values.reserve(revolutions * angle_deg.size());
    for (std::size_t k = 0; k < revolutions; ++k) {
        const double of_turn = 0.3 * randomNormal(seed, 1, k);
        for (std::size_t i = 0; i < angle_deg.size(); ++i)
            values.push_back(2 * std::cos(2 * angle_deg[i] * pi / 180) + of_turn +
                             0.4 * randomNormal(seed, 2, k * angle_deg.size() + i));
    }
    return values;
}

TEST(ErrorMotion, ItsUncertaintyIsThatOfAnotherRecordOfTheSameSpindle)
{
    const std::vector<double> angle_deg = evenAngles(100);
    constexpr std::uint64_t records = 200;
    std::vector<ErrorMotion> motions;
    double synchronous = 0, total = 0;
    for (std::uint64_t seed = 1; seed <= records; ++seed) {
        motions.push_back(errorMotion(noisyTurns(seed, 20, angle_deg), angle_deg));
        synchronous += motions.back().synchronous_um / records;
        total += motions.back().total_um / records;
    }
    int of_total = 0, of_synchronous = 0;
    double U_total = 0;
    for (const ErrorMotion& motion : motions) {
        of_total += std::abs(motion.total_um - total) <= motion.total_expanded_uncertainty_um;
        of_synchronous += std::abs(motion.synchronous_um - synchronous) <= motion.synchronous_expanded_uncertainty_um;
        U_total += motion.total_expanded_uncertainty_um / records;
    }
    EXPECT_GE(of_total, 190);
    EXPECT_GE(of_synchronous, 190);
    EXPECT_LT(U_total, 1.2);  // of 0.5 µm of noise
}

TEST(ErrorMotion, TheFormOfTheMandrelIsPartOfItsUncertainty)
{
    const std::vector<double> angle_deg = evenAngles(100);
    std::vector<double> still;
    for (int k = 0; k < 5; ++k)
        for (const double angle : angle_deg) still.push_back(2 * std::cos(2 * angle * pi / 180));
    const ErrorMotion motion = errorMotion(still, angle_deg, 0.2);
    EXPECT_NEAR(motion.total_expanded_uncertainty_um, 0.2, 1e-9);
    EXPECT_NEAR(motion.synchronous_expanded_uncertainty_um, 0.2, 1e-9);
    still.resize(2 * angle_deg.size());
    EXPECT_TRUE(std::isnan(errorMotion(still, angle_deg).total_expanded_uncertainty_um));
}

TEST(ErrorMotion, AnglesMayBeUnevenOrRepeated)
{
    std::vector<double> angle_deg, mean;
    for (std::size_t i = 0; i < 300; ++i) angle_deg.push_back(360 * randomUniform(1, 2, i));
    angle_deg.push_back(angle_deg.front());
    for (const double angle : angle_deg) mean.push_back(-3 + 5 * std::sin(angle * pi / 180));
    const ErrorMotion motion = errorMotionOfMean(mean, angle_deg);
    EXPECT_NEAR(motion.synchronous_um, 0, 1e-9);
    EXPECT_TRUE(std::isnan(motion.asynchronous_um));
    EXPECT_TRUE(std::isnan(motion.total_um));
}

TEST(ErrorMotion, TheRotatingDirectionFollowsTheAxisWhicheverWayItTurns)
{
    const std::vector<double> angle_deg = evenAngles(72);
    for (const double sense : {1.0, -1.0}) {
        std::vector<double> x, y;
        for (const double angle : angle_deg) {
            const double t = angle * pi / 180;
            x.push_back(9 * std::cos(t) + 0.5 * std::cos(t) * std::cos(3 * t));
            y.push_back(sense * (9 * std::sin(t) + 0.5 * std::sin(t) * std::cos(3 * t)));
        }
        const std::vector<double> rotating = rotatingDirection(x, y, angle_deg);
        for (std::size_t i = 0; i < rotating.size(); ++i)
            EXPECT_NEAR(rotating[i], 9 + 0.5 * std::cos(3 * angle_deg[i] * pi / 180), 1e-12);
    }
}

SectionSignals noisy(std::size_t revolutions, std::size_t points, double sigma, double drift_um)
{
    SectionSignals signals;
    signals.points = points;
    for (std::size_t k = 0; k < revolutions; ++k) signals.numbers.push_back(static_cast<std::int64_t>(k));
    for (std::size_t probe = 0; probe < 4; ++probe)
        for (std::size_t k = 0; k < revolutions; ++k)
            for (std::size_t i = 0; i < points; ++i) {
                const double turn = static_cast<double>(i) / static_cast<double>(points);
                signals.um[probe].push_back(10 + 3 * std::cos(2 * pi * turn) +
                                            drift_um * (static_cast<double>(k) + turn) +
                                            sigma * randomNormal(7, probe, k * points + i));
            }
    return signals;
}

TEST(Statistics, TheConfidenceHoldsTheTruthNineteenTimesOutOfTwenty)
{
    const SectionSignals signals = noisy(20, 4000, 0.5, 0);
    const ProbeStatistics statistics = statisticsOf(signals, Probe::Xp);
    int inside = 0;
    for (std::size_t i = 0; i < signals.points; ++i) {
        const double truth = 10 + 3 * std::cos(2 * pi * static_cast<double>(i) / 4000);
        inside += std::abs(statistics.mean_um[i] - truth) <= statistics.confidence_um[i];
        EXPECT_LE(statistics.min_um[i], statistics.mean_um[i]);
        EXPECT_GE(statistics.max_um[i], statistics.mean_um[i]);
    }
    EXPECT_NEAR(inside / 4000.0, 0.95, 0.012);
}

TEST(Drift, TheSlopeGoesAndTheMeanStays)
{
    SectionSignals signals = noisy(40, 200, 0, 0.1);
    const double before = statisticsOf(signals, Probe::X3).mean_um[50];
    const std::array<double, 4> drift = driftPerRevolution_um(signals);
    EXPECT_NEAR(drift[0], 0.1, 1e-9);
    removeDrift(signals, drift);
    const ProbeStatistics after = statisticsOf(signals, Probe::X3);
    EXPECT_NEAR(after.std_um[50], 0, 1e-9);
    EXPECT_NEAR(after.max_um[199] - after.min_um[199], 0, 1e-9);
    // At a quarter turn the mean of the drift is 0.1 · (19.5 + 0.25); its mean over the section 0.1 · 19.9975.
    EXPECT_NEAR(after.mean_um[50] - before, 0.1 * (19.9975 - 19.75), 1e-9);
}

TEST(Drift, LostRevolutionsDoNotBendTheSlope)
{
    SectionSignals signals = noisy(40, 200, 0, 0);
    for (std::size_t k = 20; k < 40; ++k) signals.numbers[k] += 30;  // thirty were left out
    for (std::size_t k = 0; k < 40; ++k)
        for (std::size_t i = 0; i < 200; ++i) signals.at(2, k, i) += 0.02 * static_cast<double>(signals.numbers[k]);
    EXPECT_NEAR(driftPerRevolution_um(signals)[2], 0.02, 1e-9);
}

TEST(Outliers, SpikesAndStrangeRevolutionsGo)
{
    SectionSignals signals = noisy(40, 200, 0.2, 0);
    signals.at(1, 5, 17) += 8;
    signals.at(3, 30, 150) -= 8;
    for (std::size_t i = 0; i < 200; ++i) signals.at(0, 12, i) += 3;
    const Rejected rejected = rejectOutliers(signals, 6);
    EXPECT_EQ(rejected.revolutions, 1);
    EXPECT_EQ(rejected.samples, 2);
    EXPECT_EQ(signals.revolutions(), 39u);
    EXPECT_EQ(signals.numbers[12], 13);
    EXPECT_TRUE(std::isnan(signals.at(1, 5, 17)));
    EXPECT_NEAR(statisticsOf(signals, Probe::Y3).mean_um[17], 10 + 3 * std::cos(2 * pi * 17 / 200), 0.2);
}

TEST(Outliers, HonestNoiseAndFewRevolutionsAreLeftAlone)
{
    SectionSignals signals = noisy(40, 200, 0.2, 0.01);
    const Rejected rejected = rejectOutliers(signals, 6);
    EXPECT_EQ(rejected.revolutions, 0);
    EXPECT_LE(rejected.samples, 1);
    SectionSignals few = noisy(4, 200, 0.2, 0);
    few.at(0, 1, 1) += 100;
    EXPECT_EQ(rejectOutliers(few, 4).samples, 0);
    SectionSignals quiet = noisy(10, 50, 0, 0);  // no scatter to measure by
    EXPECT_EQ(rejectOutliers(quiet, 4).samples, 0);
}

}  // namespace
}  // namespace lathelier::trajectory
