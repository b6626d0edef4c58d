// Impact tests on modes that are known: the response, its estimators and windows, and which hits are left out.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/receptance/tap/tap_codes.h"
#include "engine/receptance/tap/tap_hits.h"
#include "tests/engine/receptance/tapped_modes.h"

namespace lathelier::receptance {
namespace {

using lathelier::testing::HalfSine;
using lathelier::testing::Tapping;
using lathelier::testing::trueReceptance;

TapResult evaluated(const Tapping& tapping, const TapParameters& parameters = {},
                    FrfQuantity quantity = FrfQuantity::Accelerance)
{
    return evaluateTaps({tapping.record()}, quantity, parameters);
}

/// Largest error of the response, of the largest true magnitude; `decay` of the exponential window.
double largestError(const TapResult& result, const Tapping& tapping, double from_hz, double to_hz)
{
    double largest = 0, error = 0;
    for (std::size_t k = 0; k < result.response.value.size(); ++k) {
        const double frequency_hz = result.response.frequency_hz[k];
        if (frequency_hz < from_hz || frequency_hz > to_hz) continue;
        const auto truth = trueReceptance(tapping.modes, frequency_hz, result.window_decay_1_s);
        largest = std::max(largest, std::abs(truth));
        error = std::max(error, std::abs(result.response.value[k] - truth));
    }
    return error / largest;
}

Tapping threeHits()
{
    Tapping tapping;
    tapping.pulses = {{0.1, 1e-3, 200}, {0.8, 1e-3, 150}, {1.5003, 1.1e-3, 240}};
    tapping.duration_s = 2.2;
    return tapping;
}

const Note* noteOf(const TapResult& result, const NoteCode& code)
{
    const auto found =
        std::find_if(result.notes.begin(), result.notes.end(), [&](const Note& note) { return note.code == code; });
    return found == result.notes.end() ? nullptr : &*found;
}

TEST(Tap, AccelerationGivesTheReceptanceOfKnownModes)
{
    Tapping tapping = threeHits();
    tapping.force_offset = 3.5;  // amplifiers have one
    tapping.motion_offset = -400;
    const TapResult result = evaluated(tapping);
    EXPECT_EQ(result.averages, 3u);
    EXPECT_LT(largestError(result, tapping, 100, 1100), 2e-3);
    ASSERT_EQ(result.response.coherence.size(), result.response.value.size());
    for (std::size_t k = 0; k < result.response.value.size(); ++k) {
        if (result.response.frequency_hz[k] > 100) {
            EXPECT_GT(result.response.coherence[k], 0.997);  // at the antiresonance
        }
    }
    EXPECT_TRUE(noteOf(result, notes::tapForceRange));
    for (const TapHit& hit : result.hits) EXPECT_TRUE(hit.used);
    EXPECT_NEAR(result.hits[0].time_s, 0.1, 1e-4);
    EXPECT_NEAR(result.hits[2].peak_N, 240, 0.5);
    EXPECT_DOUBLE_EQ(result.resolution_hz, result.rate_hz / static_cast<double>(result.samples));
}

TEST(Tap, SoDoVelocityAndDisplacement)
{
    Tapping tapping = threeHits();
    tapping.derivative = 1;
    EXPECT_LT(largestError(evaluated(tapping, {}, FrfQuantity::Mobility), tapping, 100, 1100), 2e-3);
    tapping.derivative = 0;
    EXPECT_LT(largestError(evaluated(tapping, {}, FrfQuantity::Receptance), tapping, 20, 1100), 2e-3);
}

TEST(Tap, BothEstimatorsAgreeWithoutNoise)
{
    const Tapping tapping = threeHits();
    TapParameters parameters;
    parameters.estimator = TapEstimator::H2;
    EXPECT_LT(largestError(evaluated(tapping, parameters), tapping, 100, 1100), 2e-3);
}

// The window moves the response from iω to iω + σ, which adds σ to the decay of every mode and nothing else.
TEST(Tap, TheExponentialWindowAddsItsDecayAndSaysSo)
{
    Tapping tapping = threeHits();
    TapParameters parameters;
    parameters.window = TapWindow::ForceExponential;
    parameters.exponential_time_s = 0.1;
    const TapResult result = evaluated(tapping, parameters);
    EXPECT_DOUBLE_EQ(result.window_decay_1_s, 10);
    EXPECT_LT(largestError(result, tapping, 100, 1100), 2e-3);
    const Note* const note = noteOf(result, notes::tapWindowDecay);
    ASSERT_TRUE(note);
    EXPECT_DOUBLE_EQ(std::get<double>(*find(note->values, "window_decay_1_s")), 10);
}

TEST(Tap, AResponseThatHasNotDecayedIsNamed)
{
    Tapping tapping;
    tapping.modes = {{60, 0.002, 8000}};
    tapping.pulses = {{0.05, 1e-3, 200}};
    tapping.duration_s = 0.6;
    tapping.derivative = 0;
    EXPECT_TRUE(noteOf(evaluated(tapping, {}, FrfQuantity::Receptance), notes::tapNotDecayed));
    tapping.modes = {{60, 0.1, 8000}};
    EXPECT_FALSE(noteOf(evaluated(tapping, {}, FrfQuantity::Receptance), notes::tapNotDecayed));
}

TEST(Tap, OneHitHasNoCoherence)
{
    Tapping tapping;
    tapping.pulses = {{0.02, 1e-3, 200}};
    const TapResult result = evaluated(tapping);
    EXPECT_EQ(result.averages, 1u);
    EXPECT_TRUE(result.response.coherence.empty());
    EXPECT_TRUE(noteOf(result, notes::tapSingleHit));
    EXPECT_LT(largestError(result, tapping, 100, 1100), 2e-3);
}

// The spectrum of a half-sine of length T goes with cos(πfT)/(1 - 4f²T²).
TEST(Tap, TheForceEndsTheUsableRange)
{
    const Tapping tapping = threeHits();
    for (const double drop_dB : {10.0, 20.0}) {
        TapParameters parameters;
        parameters.force_drop_db = drop_dB;
        Tapping alike = tapping;
        for (HalfSine& pulse : alike.pulses) pulse.length_s = 1e-3;
        const TapResult result = evaluated(alike, parameters);
        double low = 100, high = 1400;
        for (int step = 0; step < 60; ++step) {
            const double f = 0.5 * (low + high), ft = f * 1e-3;
            const double size = std::abs(std::cos(std::numbers::pi * ft) / (1 - 4 * ft * ft));
            (size > std::pow(10.0, -drop_dB / 20) ? low : high) = f;
        }
        EXPECT_NEAR(result.usable_to_hz, low, 3 * result.resolution_hz) << drop_dB;
        EXPECT_LE(result.response.frequency_hz.back(), result.usable_to_hz);
        EXPECT_TRUE(noteOf(result, notes::tapForceRange));
    }
}

TEST(Tap, ADoubleHitIsLeftOutWithTimeAndReason)
{
    Tapping tapping = threeHits();
    tapping.pulses.push_back({0.8 + 0.03, 1e-3, 150 * 0.04});
    const TapResult result = evaluated(tapping);
    ASSERT_EQ(result.hits.size(), 3u);
    EXPECT_EQ(result.averages, 2u);
    EXPECT_FALSE(result.hits[1].used);
    EXPECT_EQ(result.hits[1].fault, HitFault::DoubleHit);
    EXPECT_NEAR(*result.hits[1].second_percent, 4, 0.05);
    EXPECT_NEAR(*result.hits[1].second_s, 0.8305, 1e-4);
    const Note* const note = noteOf(result, notes::tapHitsRejected);
    ASSERT_TRUE(note);
    EXPECT_EQ(std::get<std::string>(*find(note->values, "times")).substr(0, 6), "0.8000");
    TapParameters parameters;
    parameters.keep_rejected = true;
    const TapResult kept = evaluated(tapping, parameters);
    EXPECT_EQ(kept.averages, 3u);
    EXPECT_TRUE(noteOf(kept, notes::tapHitsKept));
    EXPECT_LT(largestError(kept, tapping, 100, 1000), 2e-3);  // both pulses are in the spectrum of the force
}

TEST(Tap, ABounceBelowTheLimitIsNoDoubleHit)
{
    Tapping tapping = threeHits();
    tapping.pulses.push_back({0.8 + 0.03, 1e-3, 150 * 0.015});
    EXPECT_EQ(evaluated(tapping).averages, 3u);
    TapParameters parameters;
    parameters.double_hit_percent = 1;
    EXPECT_EQ(evaluated(tapping, parameters).averages, 2u);
}

// Pulses that overlap: the force does not return to rest between them.
TEST(Tap, AnOverlappingSecondPulseIsFound)
{
    Tapping tapping = threeHits();
    tapping.pulses.push_back({0.8 + 0.0003, 1e-3, 60});
    const TapResult before = evaluated(tapping);
    EXPECT_EQ(before.averages, 3u);  // one pulse with one top
    tapping.pulses[3].start_s = 0.8 + 0.0009;
    EXPECT_EQ(evaluated(tapping).hits[1].fault, HitFault::DoubleHit);
}

TEST(Tap, ClippedSignalsAreLeftOut)
{
    const auto clipped = [](bool of_force) {
        Tapping tapping = threeHits();
        tapping.force_noise = 0.02;  // tells the resolution
        tapping.motion_noise = 5;
        TapSignals signals = tapping.record();
        std::vector<double>& values = of_force ? signals.force_N : signals.motion;
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(0.75 * signals.rate_hz);
        const auto end = values.begin() + static_cast<std::ptrdiff_t>(1.4 * signals.rate_hz);
        const double limit = 0.8 * *std::max_element(begin, end);
        std::for_each(begin, end, [limit](double& value) { value = std::min(value, limit); });
        return evaluateTaps({signals}, FrfQuantity::Accelerance, {});
    };
    const TapResult force = clipped(true);
    EXPECT_EQ(force.hits[1].fault, HitFault::OverloadForce);
    EXPECT_EQ(force.averages, 2u);
    const TapResult motion = clipped(false);
    EXPECT_EQ(motion.hits[1].fault, HitFault::OverloadResponse);
    EXPECT_EQ(motion.averages, 2u);
}

TEST(Tap, ACoarseConverterIsNoOverload)
{
    TapSignals signals = threeHits().record();
    for (double& force : signals.force_N) force = std::round(force / 2) * 2;  // 120 steps
    const double step = *std::max_element(signals.motion.begin(), signals.motion.end()) / 300;
    for (double& motion : signals.motion) motion = std::round(motion / step) * step;
    const TapResult result = evaluateTaps({signals}, FrfQuantity::Accelerance, {});
    for (const TapHit& hit : result.hits) EXPECT_EQ(hit.fault, HitFault::None) << key(hit.fault);
}

TEST(Tap, TheEndOfTheConverterIsAnOverload)
{
    TapSignals signals = threeHits().record();
    signals.at_limit.assign(signals.force_N.size(), 0);
    signals.at_limit[static_cast<std::size_t>(0.81 * signals.rate_hz)] = 2;
    EXPECT_EQ(evaluateTaps({signals}, FrfQuantity::Accelerance, {}).hits[1].fault, HitFault::OverloadResponse);
}

TEST(Tap, WeakAndIncompleteHitsAreLeftOut)
{
    Tapping tapping = threeHits();
    tapping.pulses[1].peak_N = 25;
    tapping.pulses.push_back({2.1, 1e-3, 200});
    const TapResult result = evaluated(tapping);
    ASSERT_EQ(result.hits.size(), 4u);
    EXPECT_EQ(result.hits[1].fault, HitFault::Weak);
    EXPECT_EQ(result.hits[3].fault, HitFault::Incomplete);
    EXPECT_EQ(result.averages, 2u);
}

TEST(Tap, WithoutAHitThereIsNoAnswer)
{
    Tapping tapping;
    tapping.force_noise = 1;
    const auto codeOf = [](const std::vector<TapSignals>& records) -> std::string {
        try {
            evaluateTaps(records, FrfQuantity::Accelerance, {});
        } catch (const Error& error) {
            return error.code().key;
        }
        return {};
    };
    EXPECT_EQ(codeOf({tapping.record()}), "tap_no_hit");
    tapping.force_noise = 0;
    EXPECT_EQ(codeOf({tapping.record()}), "tap_no_hit");
    tapping.pulses = {{0.1, 1e-3, 100}, {0.13, 1e-3, 50}};
    EXPECT_EQ(codeOf({tapping.record()}), "tap_no_hit_used");
    TapSignals few;
    few.rate_hz = 1000;
    few.force_N = {0, 0, 100, 0};
    few.motion = {0, 0, 1, 0};
    EXPECT_EQ(codeOf({few}), "tap_block_too_short");
}

TEST(Tap, SeveralRecordsAreAveraged)
{
    std::vector<TapSignals> records;
    Tapping tapping;
    tapping.duration_s = 0.8;
    for (int k = 0; k < 3; ++k) {
        tapping.pulses = {{0.05 + 0.01 * k, 1e-3, 100.0 + 20 * k}};
        if (k == 1) tapping.pulses.push_back({0.1, 1e-3, 30});  // a double hit does not shorten the blocks
        records.push_back(tapping.record());
    }
    const TapResult result = evaluateTaps(records, FrfQuantity::Accelerance, {});
    ASSERT_EQ(result.hits.size(), 3u);
    EXPECT_EQ(result.hits[2].record, 2u);
    EXPECT_EQ(result.averages, 2u);
    EXPECT_GT(static_cast<double>(result.samples) / result.rate_hz, 0.6);
    EXPECT_LT(largestError(result, tapping, 100, 1000), 2e-3);
}

TEST(Tap, NegativePulsesAreNamed)
{
    Tapping tapping = threeHits();
    for (HalfSine& pulse : tapping.pulses) pulse.peak_N = -pulse.peak_N;
    const TapResult result = evaluated(tapping);
    EXPECT_EQ(result.averages, 3u);
    EXPECT_TRUE(noteOf(result, notes::tapForceNegative));
    EXPECT_LT(largestError(result, tapping, 100, 1100), 2e-3);
}

/// Hits with white noise, and what it does at lines from 100 to 600 Hz: ratios of noise to signal in power.
struct Noisy {
    Tapping tapping;
    double block_s = 0.2;
    int hits = 100;

    Noisy(double force_noise, double motion_noise)
    {
        tapping.rate_hz = 10240;
        tapping.modes = {{300, 0.05, 12000}};
        for (int k = 0; k < hits; ++k) tapping.pulses.push_back({0.05 + 0.3 * k, 1e-3, 200});
        tapping.duration_s = 0.3 * hits + 0.1;
        tapping.force_noise = force_noise;
        tapping.motion_noise = motion_noise;
    }

    TapResult result(TapEstimator estimator) const
    {
        TapParameters parameters;
        parameters.estimator = estimator;
        parameters.block_s = block_s;
        parameters.keep_rejected = true;
        return evaluated(tapping, parameters);
    }

    /// Energy density spectrum of a sampled half-sine: |F|² = (2TA/π · cos(πfT)/(1-4f²T²) · rate)².
    double forcePower(double f) const
    {
        const double T = 1e-3, ft = f * T;
        const double size = 2 * T * 200 / std::numbers::pi * std::cos(std::numbers::pi * ft) / (1 - 4 * ft * ft);
        return size * size * tapping.rate_hz * tapping.rate_hz;
    }
    double samples() const { return block_s * tapping.rate_hz; }
    /// Noise of the hammer, and of the sensor, by the power of the signal.
    double forceRatio(double f) const { return samples() * tapping.force_noise * tapping.force_noise / forcePower(f); }
    double motionRatio(double f) const
    {
        const double omega = 2 * std::numbers::pi * f;
        const double accelerance = omega * omega * std::abs(trueReceptance(tapping.modes, f));
        return samples() * tapping.motion_noise * tapping.motion_noise / (forcePower(f) * accelerance * accelerance);
    }

    /// Means over the lines of |found| / |true|, its expectation, coherence, and its expectation.
    struct Means {
        double size = 0, expected_size = 0, coherence = 0, expected_coherence = 0;
    };
    Means means(TapEstimator estimator) const
    {
        const TapResult found = result(estimator);
        Means sum;
        double count = 0;
        for (std::size_t k = 0; k < found.response.value.size(); ++k) {
            const double f = found.response.frequency_hz[k];
            if (f < 150 || f > 500) continue;
            const double a = forceRatio(f), b = motionRatio(f);
            sum.size += std::abs(found.response.value[k]) / std::abs(trueReceptance(tapping.modes, f));
            sum.expected_size += estimator == TapEstimator::H1 ? 1 / (1 + a) : 1 + b;
            sum.coherence += found.response.coherence[k];
            sum.expected_coherence += 1 / ((1 + a) * (1 + b));
            ++count;
        }
        EXPECT_GT(count, 50);
        return {sum.size / count, sum.expected_size / count, sum.coherence / count, sum.expected_coherence / count};
    }
};

TEST(Tap, NoiseOfTheHammerMakesH1TooLow)
{
    const Noisy noisy(9, 0);
    const Noisy::Means h1 = noisy.means(TapEstimator::H1);
    EXPECT_LT(h1.expected_size, 0.93);
    EXPECT_NEAR(h1.size, h1.expected_size, 0.01);
    EXPECT_NEAR(h1.coherence, h1.expected_coherence, 0.01);
    EXPECT_NEAR(noisy.means(TapEstimator::H2).size, 1, 0.01);
}

TEST(Tap, NoiseOfTheSensorMakesH2TooHigh)
{
    const Noisy noisy(0, 4e3);
    const Noisy::Means h2 = noisy.means(TapEstimator::H2);
    EXPECT_GT(h2.expected_size, 1.03);
    EXPECT_NEAR(h2.size / h2.expected_size, 1, 0.02);
    EXPECT_NEAR(h2.coherence, h2.expected_coherence, 0.01);
    EXPECT_NEAR(noisy.means(TapEstimator::H1).size, 1, 0.01);
}

// Lengths and forces in other units scale what comes out by their own power.
TEST(Tap, ScalesWithForceAndMotion)
{
    TapSignals signals = threeHits().record();
    const TapResult plain = evaluateTaps({signals}, FrfQuantity::Accelerance, {});
    for (double& force : signals.force_N) force *= 8;
    for (double& motion : signals.motion) motion *= 0.25;
    const TapResult scaled = evaluateTaps({signals}, FrfQuantity::Accelerance, {});
    ASSERT_EQ(plain.response.value.size(), scaled.response.value.size());
    for (std::size_t k = 0; k < plain.response.value.size(); ++k)
        EXPECT_NEAR(std::abs(scaled.response.value[k] * 32.0 / plain.response.value[k] - 1.0), 0, 1e-12);
    EXPECT_NEAR(scaled.hits[0].peak_N, 8 * plain.hits[0].peak_N, 1e-9);
}

}  // namespace
}  // namespace lathelier::receptance
