// Kinds of noise that measurements have, laid on parts of known form: for the coverage of stated uncertainties.
#pragma once

#include <functional>

#include "engine/core/random.h"
#include "engine/form/roundness/roundness.h"
#include "tests/engine/form/made_profile.h"

namespace lathelier::form {

/// Deviations in mm of n points, drawn under a seed.
using Noise = std::function<std::vector<double>(std::size_t n, std::uint64_t seed)>;

inline std::vector<double> white(std::size_t n, std::uint64_t seed)
{
    std::vector<double> noise(n);
    for (std::size_t i = 0; i < n; ++i) noise[i] = .0004 * randomNormal(seed, 0, i);
    return noise;
}

/// Mean of `width` neighbours, as a filter in the instrument leaves them.
inline std::vector<double> averaged(std::size_t n, std::uint64_t seed, std::size_t width)
{
    const std::vector<double> source = white(n, seed);
    std::vector<double> noise(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < width; ++k) noise[i] += source[(i + k) % n] / std::sqrt(static_cast<double>(width));
    return noise;
}

/// First-order process: each point keeps a share of its neighbour's.
inline std::vector<double> following(std::size_t n, std::uint64_t seed, double share)
{
    std::vector<double> noise(n);
    double last = 0;
    for (std::size_t i = 0; i < 3 * n; ++i) {
        last = share * last + std::sqrt(1 - share * share) * .0004 * randomNormal(seed, 0, i);
        noise[i % n] = last;
    }
    return noise;
}

inline std::vector<double> spiky(std::size_t n, std::uint64_t seed)
{
    std::vector<double> noise = white(n, seed);
    for (std::size_t i = 0; i < n; ++i)
        if (randomUniform(seed, 1, i) < .02) noise[i] += .005 * (randomUniform(seed, 2, i) - .5 > 0 ? 1 : -1);
    return noise;
}

/// Jumps to another level now and then, as contacts that slip.
inline std::vector<double> stepped(std::size_t n, std::uint64_t seed)
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
inline Profile measuredProfile(std::size_t n, const Noise& noise, std::uint64_t seed, double step_mm)
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

struct NoiseCase {
    const char* name;
    Noise noise;
    double step_mm = 0;
};

inline std::vector<NoiseCase> noiseCases()
{
    return {{"white", white},
            {"averaged over 5", [](std::size_t n, std::uint64_t seed) { return averaged(n, seed, 5); }},
            {"following by 0.8", [](std::size_t n, std::uint64_t seed) { return following(n, seed, .8); }},
            {"quantised finely", white, .0005},
            {"quantised coarsely", [](std::size_t n, std::uint64_t) { return std::vector<double>(n); }, .001},
            {"spiky", spiky},
            {"stepped", stepped}};
}

/// Coverage statistics of repeated measurements under one kind of noise.
struct Coverage {
    int runs = 0, covered = 0;
    double uncertainty_um = 0, error_um = 0;  ///< mean values
};

/// The same part without noise.
inline Profile trueProfile(std::size_t n, std::uint64_t seed)
{
    return measuredProfile(
        n, [](std::size_t count, std::uint64_t) { return std::vector<double>(count); }, seed, 0);
}

inline Coverage coverageOf(const NoiseCase& kind, std::size_t n, int runs)
{
    Coverage result;
    result.runs = runs;
    for (int i = 1; i <= runs; ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        const RoundnessResult measured = roundness(measuredProfile(n, kind.noise, seed, kind.step_mm));
        const double truth_um = fitCircles(trueProfile(n, seed).points_mm).MZCI.RONt_um;
        const double off_um = std::abs(headlineDeviation_um(measured) - truth_um);
        result.covered += off_um <= measured.RONt_expanded_uncertainty_um;
        result.uncertainty_um += measured.RONt_expanded_uncertainty_um / runs;
        result.error_um += off_um / runs;
    }
    return result;
}

}  // namespace lathelier::form
