#include "engine/signal/closed_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/signal/harmonics.h"

namespace lathelier::signal {
namespace {

std::vector<double> evenAngles(std::size_t n)
{
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i) result[i] = turn_rad * static_cast<double>(i) / static_cast<double>(n);
    return result;
}

/// Even steps, each moved at random by up to `share` of a step.
std::vector<double> unevenAngles(std::size_t n, double share)
{
    std::vector<double> result = evenAngles(n);
    for (std::size_t i = 0; i < n; ++i)
        result[i] += share * turn_rad / static_cast<double>(n) * (2 * randomUniform(11, 0, i) - 1);
    return result;
}

struct Wave {
    int upr;
    double amplitude, phase;
};

std::vector<double> wavesAt(const std::vector<double>& angle, const std::vector<Wave>& waves, double mean = 25)
{
    std::vector<double> result;
    for (const double a : angle) {
        double r = mean;
        for (const Wave& w : waves) r += w.amplitude * std::cos(w.upr * a - w.phase);
        result.push_back(r);
    }
    return result;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double result = 0;
    for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, std::abs(a[i] - b[i]));
    return result;
}

TEST(GaussianFilter, HasTheTransmissionOfTheTable)
{
    EXPECT_NEAR(gaussianTransmission(5, 15), .9259, 5e-5);
    EXPECT_DOUBLE_EQ(gaussianTransmission(15, 15), .5);
    EXPECT_NEAR(gaussianTransmission(25, 15), .1458, 5e-5);
    EXPECT_NEAR(gaussianTransmission(15, 50), .9395, 5e-5);
    EXPECT_DOUBLE_EQ(gaussianTransmission(50, 50), .5);
    EXPECT_DOUBLE_EQ(gaussianTransmission(100, 50), .0625);
    EXPECT_NEAR(gaussianTransmission(50, 150), .9259, 5e-5);
}

TEST(GaussianFilter, DampsEveryWaveByItsTransmission)
{
    for (const std::size_t n : {200u, 201u, 211u, 3600u}) {
        const std::vector<double> angle = evenAngles(n);
        for (const int k : {1, 2, 15, 49, 90}) {
            const std::vector<double> values = wavesAt(angle, {{k, .01, .3}});
            const double t = gaussianTransmission(k, 15);
            EXPECT_LT(largestDifference(filterClosed(values, {{}, 15}), wavesAt(angle, {{k, .01 * t, .3}})), 1e-14);
            EXPECT_LT(largestDifference(filterClosed(values, {15, {}}), wavesAt(angle, {{k, .01 * (1 - t), .3}})),
                      1e-14);
            const double band = (1 - t) * gaussianTransmission(k, 50);
            EXPECT_LT(largestDifference(filterClosed(values, {15, 50}), wavesAt(angle, {{k, .01 * band, .3}})), 1e-14);
        }
    }
}

TEST(GaussianFilter, UnevenAnglesGiveWhatEvenOnesGive)
{
    const std::vector<Wave> waves{{2, .005, 1}, {7, .003, 2}, {40, .001, .5}};
    const TransmissionBand bands[] = {{{}, 15}, {{}, 50}, {15, {}}, {5, 30}};
    for (const std::size_t n : {721u, 3600u}) {
        const std::vector<double> angle = unevenAngles(n, .3);
        for (const TransmissionBand& band : bands) {
            std::vector<Wave> damped = waves;
            for (Wave& w : damped) w.amplitude *= band.transmission(w.upr);
            const FilteredValues found = filterClosedAt(angle, wavesAt(angle, waves), band);
            EXPECT_EQ(found.method, FilterMethod::Series);
            EXPECT_LT(largestDifference(found.values, wavesAt(angle, damped)), 1e-10);
        }
    }
}

TEST(GaussianFilter, AnEccentricProfileOf200PointsIsFilteredExactly)
{
    // Even in index, uneven about its own centre: what a probe beside the axis records.
    std::vector<double> angle = evenAngles(200);
    for (double& a : angle) a += .002 * std::sin(a - .4);
    const std::vector<Wave> waves{{2, .005, 1}, {5, .003, 2}, {15, .001, .5}};
    std::vector<Wave> damped = waves;
    for (Wave& w : damped) w.amplitude *= gaussianTransmission(w.upr, 15);
    EXPECT_LT(largestDifference(filterClosedAt(angle, wavesAt(angle, waves), {{}, 15}).values, wavesAt(angle, damped)),
              1e-10);
}

TEST(GaussianFilter, DoesNotRingBesideAKeyway)
{
    std::vector<double> angle, missing;
    for (const double a : evenAngles(3600)) (a > 1 && a < 1 + turn_rad * 8 / 360 ? missing : angle).push_back(a);
    const std::vector<Wave> waves{{2, .005, 1}, {3, .004, 2}, {5, .002, 0}};
    const std::vector<double> values = wavesAt(angle, waves);
    const FilteredValues found = filterClosedAt(angle, values, {{}, 50});
    EXPECT_EQ(found.method, FilterMethod::Regression);
    std::vector<Wave> damped = waves;
    for (Wave& w : damped) w.amplitude *= gaussianTransmission(w.upr, 50);
    double beside = 0, away = 0;
    for (std::size_t i = 0; i < angle.size(); ++i) {
        const double error = std::abs(found.values[i] - wavesAt({angle[i]}, damped)[0]);
        const double distance =
            std::abs(std::remainder(angle[i] - 1 - turn_rad * 4 / 360, turn_rad)) - turn_rad * 4 / 360;
        (distance < turn_rad * 1.4 / 50 ? beside : away) =
            std::max(distance < turn_rad * 1.4 / 50 ? beside : away, error);
    }
    EXPECT_LT(away, 1e-10);     // the same as without a gap
    EXPECT_LT(beside, 1.5e-4);  // 1.4 % of the form of 11 µm
    // A straight line or a circle stays what it is, whatever the gap.
    const std::vector<double> flat(angle.size(), 25.0);
    EXPECT_LT(largestDifference(filterClosedAt(angle, flat, {{}, 50}).values, flat), 1e-12);
}

TEST(GaussianFilter, GapsDoNotInventNoise)
{
    // White noise stays below its own level everywhere, also at the edges of many gaps.
    std::vector<double> angle;
    for (const double a : evenAngles(3600))
        if (std::fmod(a, turn_rad / 7) > .1) angle.push_back(a);
    std::vector<double> values;
    for (std::size_t i = 0; i < angle.size(); ++i) values.push_back(25 + .001 * randomNormal(2, 0, i));
    for (const double v : filterClosedAt(angle, values, {{}, 50}).values) EXPECT_LT(std::abs(v - 25), .001);
}

TEST(GaussianFilter, OrderAndDuplicatesDoNotMatter)
{
    std::vector<double> angle = unevenAngles(400, .2);
    const std::vector<Wave> waves{{3, .004, 2}};
    const std::vector<double> sorted = filterClosedAt(angle, wavesAt(angle, waves), {{}, 15}).values;
    std::vector<double> mixed, expected;
    for (std::size_t i = 0; i < 400; ++i) {
        mixed.push_back(angle[i * 77 % 400] - turn_rad);
        expected.push_back(sorted[i * 77 % 400]);
    }
    EXPECT_LT(largestDifference(filterClosedAt(mixed, wavesAt(mixed, waves), {{}, 15}).values, expected), 1e-11);
    mixed.push_back(mixed[5]);
    expected.push_back(expected[5]);
    EXPECT_LT(largestDifference(filterClosedAt(mixed, wavesAt(mixed, waves), {{}, 15}).values, expected), 1e-10);
}

void expectWaves(const std::vector<Harmonic>& found, const std::vector<Wave>& waves, double tolerance)
{
    for (const Harmonic& h : found) {
        const auto wave = std::find_if(waves.begin(), waves.end(), [&](const Wave& w) { return w.upr == h.upr; });
        if (wave == waves.end()) {
            EXPECT_LT(h.amplitude, tolerance) << h.upr;
        } else {
            EXPECT_NEAR(h.amplitude, wave->amplitude, tolerance) << h.upr;
            EXPECT_NEAR(std::remainder(h.phase_rad - wave->phase, turn_rad), 0, tolerance / wave->amplitude) << h.upr;
        }
    }
}

const std::vector<Wave> someWaves{{1, .05, -2}, {2, .005, 1}, {3, .004, 3}, {15, .001, .5}, {60, .0005, -1}};

TEST(Harmonics, EvenAngles)
{
    for (const std::size_t n : {200u, 201u, 3600u}) {
        const std::vector<double> values = wavesAt(evenAngles(n), someWaves);
        const std::vector<Harmonic> found = harmonicsUniform(values, 500);
        EXPECT_EQ(found.size(), std::min<std::size_t>(n / 2, 500));
        expectWaves(found, someWaves, 1e-13);
        expectWaves(harmonicsAt(evenAngles(n), values, 500), someWaves, 1e-13);
        std::vector<double> shifted = evenAngles(n);
        for (double& a : shifted) a += 1.234;
        expectWaves(harmonicsAt(shifted, wavesAt(shifted, someWaves), 500), someWaves, 1e-13);
    }
}

TEST(Harmonics, UnevenAnglesToTheLastOrder)
{
    std::vector<double> angle = evenAngles(200);
    for (double& a : angle) a += .002 * std::sin(a - .4);
    const std::vector<Harmonic> found = harmonicsAt(angle, wavesAt(angle, someWaves), 500);
    EXPECT_EQ(found.size(), 100u);
    expectWaves(found, someWaves, 1e-9);
    for (const double share : {.1, .45}) {
        angle = unevenAngles(3600, share);
        const std::vector<Harmonic> many = harmonicsAt(angle, wavesAt(angle, someWaves), 500);
        EXPECT_EQ(many.size(), 500u);
        expectWaves(many, someWaves, 1e-10);
    }
}

/// Density 1 + depth · cos θ, as a hand-turned table or a stretched time base leaves it.
std::vector<double> denser(std::size_t n, double depth)
{
    std::vector<double> result;
    for (const double share : evenAngles(n)) {
        double a = share;
        for (int i = 0; i < 60; ++i) a = share - depth * std::sin(a);
        result.push_back(a);
    }
    return result;
}

TEST(Harmonics, SmoothlyUnevenAnglesCarryWhatTheWidestSpacingCarries)
{
    for (const double depth : {.2, .35, .5}) {
        const std::vector<double> angle = denser(200, depth);
        std::vector<double> values = wavesAt(angle, {{2, .004, 1}});
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += .0008 * randomNormal(8, 0, i);
        const std::vector<Harmonic> found = harmonicsAt(angle, values, 500);
        const AngularSampling sampling = sampleAngles(angle);
        EXPECT_EQ(static_cast<int>(found.size()), carriedOrders(sampling).determined);
        EXPECT_LT(found.size(), 100 * (1 - depth) + 1);
        EXPECT_GT(found.size(), 75 * (1 - depth));
        EXPECT_NEAR(found[1].amplitude, .004, .0003);
        // White noise gives amplitudes of √(4σ²/n) each, here 0.11 µm; badly conditioned orders gave 114 µm.
        for (const Harmonic& h : found) EXPECT_TRUE(h.upr == 2 || h.amplitude < .0006) << h.upr << " of " << depth;
    }
}

TEST(GaussianFilter, NeverAddsToASquareHoweverItIsSampled)
{
    for (std::uint64_t seed = 0; seed < 40; ++seed)
        for (const double cutoff : {15., 50., 150.}) {
            std::vector<double> angle;
            for (std::size_t i = 0; i < 200; ++i) angle.push_back(turn_rad * randomUniform(seed, 3, i));
            if (seed % 2) angle = denser(200, .02 * static_cast<double>(seed));
            std::vector<double> values;
            for (const double a : angle) {
                const double side = std::remainder(a, turn_rad / 4);
                values.push_back(10 / std::cos(side));
            }
            const auto [low, high] = std::minmax_element(values.begin(), values.end());
            const std::vector<double> filtered = filterClosedAt(angle, values, {{}, cutoff}).values;
            const auto [least, most] = std::minmax_element(filtered.begin(), filtered.end());
            EXPECT_LE(*most - *least, *high - *low) << seed << " " << cutoff;
        }
}

TEST(Harmonics, BesideAKeywayTheLowOrdersAreExact)
{
    std::vector<double> angle;
    for (const double a : evenAngles(3600))
        if (a < 1 || a > 1 + turn_rad * 8 / 360) angle.push_back(a);
    const std::vector<Wave> low{{2, .005, 1}, {3, .004, 3}, {15, .001, .5}};
    const std::vector<Harmonic> found = harmonicsAt(angle, wavesAt(angle, low), 500);
    EXPECT_EQ(found.size(), 500u);
    expectWaves(found, low, 1e-9);
    const std::vector<Wave> high{{2, .005, 1}, {90, .001, .5}};
    EXPECT_NEAR(harmonicsAt(angle, wavesAt(angle, high), 500)[89].amplitude, .001, 5e-5);
}

TEST(Harmonics, APartialArcHasNone)
{
    std::vector<double> angle;
    for (int i = 0; i < 200; ++i) angle.push_back(.01 * i);
    EXPECT_TRUE(harmonicsAt(angle, wavesAt(angle, someWaves), 100).empty());
}

TEST(Harmonics, AtHalfTheCountTheSmallestAmplitudeThatExplainsTheSamples)
{
    std::vector<double> values;
    for (int i = 0; i < 8; ++i) values.push_back(i % 2 ? -1 : 1);
    const std::vector<Harmonic> found = harmonicsUniform(values, 500);
    ASSERT_EQ(found.size(), 4u);
    EXPECT_NEAR(found[3].amplitude, 1, 1e-14);
    EXPECT_NEAR(found[3].phase_rad, 0, 1e-14);
}

}  // namespace
}  // namespace lathelier::signal
