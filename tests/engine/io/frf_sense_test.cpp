// Sign and sense of time of a response, by the circle of its strongest resonance.
#include "engine/io/frf/frf_sense.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "tests/engine/io/frf_files.h"

namespace lathelier {
namespace {

enum class Way { AsIs, Turned, Conjugated, Both };

Frf measured(FrfQuantity quantity, Way way, double step_hz, double noise)
{
    Frf frf = testing::modeFrf(quantity, static_cast<int>(900 / step_hz), step_hz, step_hz).frf;
    const double size = std::abs(testing::receptance_mm_N(200));
    std::uint64_t index = 0;
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        const double w = 2 * std::numbers::pi * 200;
        const double unit = quantity == FrfQuantity::Receptance ? size
                            : quantity == FrfQuantity::Mobility ? size * w
                                                                : size * w * w;
        frf.value[i] += noise * unit * std::complex<double>(randomNormal(7, 0, index), randomNormal(7, 0, index + 1));
        index += 2;
        if (way == Way::Turned || way == Way::Both) frf.value[i] = -frf.value[i];
        if (way == Way::Conjugated || way == Way::Both) frf.value[i] = std::conj(frf.value[i]);
    }
    return frf;
}

}  // namespace

TEST(FrfSense, TurnedAndConjugatedAreToldApart)
{
    for (const FrfQuantity quantity : {FrfQuantity::Receptance, FrfQuantity::Mobility, FrfQuantity::Accelerance})
        for (const double step_hz : {0.5, 2.0, 4.0})  // the half-power band is 8 Hz wide
            for (const Way way : {Way::AsIs, Way::Turned, Way::Conjugated, Way::Both}) {
                const io::FrfSense sense = io::senseOf(measured(quantity, way, step_hz, 0.003));
                EXPECT_NEAR(sense.frequency_hz, 200, 5);
                EXPECT_EQ(sense.is_conjugated, way == Way::Conjugated || way == Way::Both) << step_hz;
                EXPECT_EQ(sense.is_turned, way == Way::Turned || way == Way::Both) << step_hz;
            }
}

TEST(FrfSense, NothingIsSaidOfNoiseAndOfFewLines)
{
    EXPECT_FALSE(io::senseOf({}).is_conjugated);
    int claims = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Frf noise;
        for (std::uint64_t i = 0; i < 400; ++i) {
            noise.frequency_hz.push_back(static_cast<double>(i + 1));
            noise.value.emplace_back(randomNormal(seed, 0, 2 * i), randomNormal(seed, 0, 2 * i + 1));
        }
        claims += io::senseOf(noise).is_conjugated.has_value() ? 1 : 0;
    }
    EXPECT_EQ(claims, 0);
    // An accelerance with even noise, as a receptance: its low lines are all noise.
    int wrong = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Frf low;
        for (std::uint64_t i = 0; i < 1600; ++i) {
            const double f = 0.5 * static_cast<double>(i + 1);
            low.frequency_hz.push_back(f);
            const std::complex<double> noise(randomNormal(seed, 1, 2 * i), randomNormal(seed, 1, 2 * i + 1));
            low.value.push_back(testing::receptance_mm_N(f) + noise * (0.0025 / 300) * std::pow(200 / f, 2));
        }
        wrong += io::senseOf(low).is_conjugated.value_or(false) ? 1 : 0;
    }
    EXPECT_LE(wrong, 2);
}

}  // namespace lathelier
