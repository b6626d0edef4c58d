// The noise of a measured response against the noise that was added to a known one.
#include "engine/io/frf/frf_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/io/frf/measured_frf.h"

namespace lathelier::io {
namespace {

struct Recipe {
    bool coherence = false;
    double knee_hz = 0;       ///< below it the noise rises as 1/f² in amplitude
    double proportional = 0;  ///< part of the noise as a share of the response
    double first_hz = 5;
    double step_hz = 0.5;
};

struct Made {
    Frf frf;
    std::vector<double> noise;  ///< true standard deviation of each component
};

/// The accelerance of two modes at 317 and 900 Hz; the sensor's noise is a hundredth of the highest line.
Made made(const Recipe& recipe, std::uint64_t seed)
{
    Made result;
    Frf& frf = result.frf;
    frf.quantity = FrfQuantity::Accelerance;
    double peak = 0;
    for (double f = recipe.first_hz; f <= 800; f += recipe.step_hz) {
        const double w2 = std::pow(2 * std::numbers::pi * f, 2), a = f / 317, b = f / 900;
        frf.frequency_hz.push_back(f);
        frf.value.push_back(-w2 / 12000 / std::complex<double>(1 - a * a, 0.044 * a) -
                            w2 / 30000 / std::complex<double>(1 - b * b, 0.056 * b));
        peak = std::max(peak, std::abs(frf.value.back()));
    }
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        const double size = std::abs(frf.value[i]), rise = std::pow(recipe.knee_hz / frf.frequency_hz[i], 4);
        const double sensor = recipe.proportional > 0 ? 0 : peak / 100 / std::numbers::sqrt2;
        result.noise.push_back(std::hypot(sensor * std::sqrt(1 + rise), recipe.proportional * size));
        const double noise = result.noise.back();
        if (recipe.coherence) frf.coherence.push_back(size * size / (size * size + 2 * noise * noise));
        frf.value[i] += noise * std::complex<double>(randomNormal(seed, 1, i), randomNormal(seed, 2, i));
    }
    return result;
}

/// Mean of ln(estimate/truth), and the largest factor between them, over the lines from `from` on.
std::pair<double, double> compared(const Recipe& recipe, std::size_t from)
{
    double sum = 0, count = 0, largest = 1;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Made one = made(recipe, seed);
        const std::vector<double> noise = noiseOf(one.frf);
        EXPECT_EQ(noise.size(), one.noise.size());
        for (std::size_t i = from; i < noise.size(); ++i, ++count) {
            const double ratio = noise[i] / one.noise[i];
            sum += std::log(ratio);
            largest = std::max({largest, ratio, 1 / ratio});
        }
    }
    return {sum / count, largest};
}

}  // namespace

TEST(FrfNoise, OfASensorIsFoundInWhatItMeasured)
{
    for (const double knee_hz : {0.0, 30.0})
        for (const double first_hz : {0.5, 5.0, 20.0}) {
            const auto [bias, largest] = compared({false, knee_hz, 0, first_hz, 0.5}, 4);
            EXPECT_NEAR(bias, 0, 0.1) << knee_hz << ' ' << first_hz;
            EXPECT_LT(largest, 2.5) << knee_hz << ' ' << first_hz;
        }
}

TEST(FrfNoise, FollowsTheCoherence)
{
    for (const double knee_hz : {0.0, 30.0}) {
        const auto [bias, largest] = compared({true, knee_hz, 0, 5, 0.5}, 0);
        EXPECT_NEAR(bias, 0, 0.2) << knee_hz;
        EXPECT_LT(largest, 2.5) << knee_hz;
    }
}

TEST(FrfNoise, ProportionalToTheResponseIsFoundAtThePeak)
{
    Recipe recipe;
    recipe.proportional = 0.01;
    const auto [bias, largest] = compared(recipe, 0);
    EXPECT_NEAR(bias, 0, 0.3);
    EXPECT_LT(largest, 3);  // at the antiresonance, where that of its neighbours is taken
}

TEST(FrfNoise, IsCarriedIntoTheReceptance)
{
    Made one = made({}, 1);
    one.frf.noise = noiseOf(one.frf);
    const Frf receptance = toReceptance(one.frf);
    ASSERT_EQ(receptance.noise.size(), receptance.value.size());
    for (const std::size_t i : {0UL, 100UL, 1000UL})
        EXPECT_NEAR(receptance.noise[i] / std::abs(receptance.value[i]), one.frf.noise[i] / std::abs(one.frf.value[i]),
                    1e-12);
}

TEST(FrfNoise, OfExactValuesIsSmall)
{
    Recipe recipe;
    recipe.proportional = 1e-12;
    const Frf frf = made(recipe, 1).frf;
    const std::vector<double> noise = noiseOf(frf);
    for (std::size_t i = 0; i < noise.size(); ++i) EXPECT_LT(noise[i], 2e-3 * std::abs(frf.value[i])) << i;
}

TEST(FrfNoise, NeedsNineLines)
{
    Frf few;
    few.frequency_hz = {1, 2, 3, 4, 5, 6, 7, 8};
    few.value.resize(8);
    EXPECT_TRUE(noiseOf(few).empty());
    few.frequency_hz.push_back(9);
    few.value.resize(9);
    EXPECT_EQ(noiseOf(few).size(), 9U);  // all 0: no noise, no division by it
    for (const double one : noiseOf(few)) EXPECT_TRUE(std::isfinite(one));
}

}  // namespace lathelier::io
