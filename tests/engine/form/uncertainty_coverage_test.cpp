// The stated uncertainty of RONt against the truth, over kinds of noise that measurements have.
#include <gtest/gtest.h>

#include <functional>

#include "engine/core/random.h"
#include "engine/form/form_codes.h"
#include "engine/form/roundness.h"
#include "tests/engine/form/made_profile.h"

namespace lathelier {
namespace {

/// Deviations in mm of n points, drawn under a seed.
using Noise = std::function<std::vector<double>(std::size_t n, std::uint64_t seed)>;

std::vector<double> white(std::size_t n, std::uint64_t seed)
{
    std::vector<double> noise(n);
    for (std::size_t i = 0; i < n; ++i) noise[i] = .0004 * randomNormal(seed, 0, i);
    return noise;
}

/// Mean of `width` neighbours, as a filter in the instrument leaves them.
std::vector<double> averaged(std::size_t n, std::uint64_t seed, std::size_t width)
{
    const std::vector<double> source = white(n, seed);
    std::vector<double> noise(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < width; ++k) noise[i] += source[(i + k) % n] / std::sqrt(static_cast<double>(width));
    return noise;
}

/// First-order process: each point keeps a share of its neighbour's.
std::vector<double> following(std::size_t n, std::uint64_t seed, double share)
{
    std::vector<double> noise(n);
    double last = 0;
    for (std::size_t i = 0; i < 3 * n; ++i) {
        last = share * last + std::sqrt(1 - share * share) * .0004 * randomNormal(seed, 0, i);
        noise[i % n] = last;
    }
    return noise;
}

std::vector<double> spiky(std::size_t n, std::uint64_t seed)
{
    std::vector<double> noise = white(n, seed);
    for (std::size_t i = 0; i < n; ++i)
        if (randomUniform(seed, 1, i) < .02) noise[i] += .005 * (randomUniform(seed, 2, i) - .5 > 0 ? 1 : -1);
    return noise;
}

/// Jumps to another level now and then, as contacts that slip.
std::vector<double> stepped(std::size_t n, std::uint64_t seed)
{
    std::vector<double> noise = white(n, seed);
    double level = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (randomUniform(seed, 1, i) < .1) level = .001 * randomNormal(seed, 2, i);
        noise[i] = .25 * noise[i] + level;
    }
    return noise;
}

/// A part of its own for every seed: rounding depends on where the extremes lie.
Profile measured(std::size_t n, const Noise& noise, std::uint64_t seed, double step_mm)
{
    const auto any = [seed](std::uint64_t k) { return randomUniform(seed, 7, k); };
    const std::vector<Lobe> lobes{
        {2, .002 + .002 * any(0), 6 * any(1)}, {3, .003 + .002 * any(2), 6 * any(3)}, {7, .001, 6 * any(4)}};
    const std::vector<double> angle = evenAngles(n);
    const std::vector<double> deviation = noise(n, seed);
    Profile profile;
    for (std::size_t i = 0; i < n; ++i) {
        double r = 25 + deviation[i];
        for (const Lobe& lobe : lobes) r += lobe.amplitude_mm * std::cos(lobe.upr * angle[i] - lobe.phase_rad);
        if (step_mm > 0) r = step_mm * std::round(r / step_mm);
        profile.points_mm.emplace_back(r * std::cos(angle[i]), r * std::sin(angle[i]));
    }
    return profile;
}

struct Case {
    const char* name;
    Noise noise;
    double step_mm = 0;
};

class UncertaintyCoverage : public testing::TestWithParam<std::tuple<int, std::size_t>> {};

std::vector<Case> cases()
{
    return {{"white", white},
            {"averaged over 5", [](std::size_t n, std::uint64_t seed) { return averaged(n, seed, 5); }},
            {"following by 0.8", [](std::size_t n, std::uint64_t seed) { return following(n, seed, .8); }},
            {"quantised finely", white, .0005},
            {"quantised coarsely", [](std::size_t n, std::uint64_t) { return std::vector<double>(n); }, .001},
            {"spiky", spiky},
            {"stepped", stepped}};
}

TEST_P(UncertaintyCoverage, HoldsTheTruth)
{
    const Case kind = cases()[static_cast<std::size_t>(std::get<0>(GetParam()))];
    const std::size_t n = std::get<1>(GetParam());
    const auto none = [](std::size_t count, std::uint64_t) { return std::vector<double>(count); };
    constexpr int runs = 40;
    int covered = 0;
    double sum = 0, error = 0;
    for (int i = 0; i < runs; ++i) {
        const RoundnessResult result =
            roundness(measured(n, kind.noise, static_cast<std::uint64_t>(i) + 1, kind.step_mm));
        const std::vector<Eigen::Vector2d> quiet = measured(n, none, static_cast<std::uint64_t>(i) + 1, 0).points_mm;
        const double off = std::abs(headlineDeviation_um(result) - fitCircles(quiet).MZCI.RONt_um);
        covered += off <= result.RONt_expanded_uncertainty_um;
        sum += result.RONt_expanded_uncertainty_um;
        error += off;
    }
    EXPECT_GE(covered, .85 * runs) << kind.name;  // of 40, for 95 of 100
    EXPECT_LT(sum, 7 * error) << kind.name << ": covers by being large";
}

INSTANTIATE_TEST_SUITE_P(Kinds, UncertaintyCoverage,
                         testing::Combine(testing::Range(0, 7), testing::Values(48u, 200u, 720u)));

}  // namespace
}  // namespace lathelier
