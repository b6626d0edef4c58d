// Roundness of one profile: the whole evaluation, and its parts.
#include <benchmark/benchmark.h>

#include <numbers>

#include "engine/core/random.h"
#include "engine/form/roundness/prepared_profile.h"
#include "engine/form/roundness/superimpose.h"
#include "tests/engine/form/noise_kinds.h"

namespace lathelier::form {
namespace {

/// A turned part beside the origin: lobes, roughness, eccentricity of 50 µm.
Profile turned(std::int64_t points)
{
    return lobedProfile(evenAngles(static_cast<std::size_t>(points)),
                        {{2, .003, 1}, {3, .002, 0}, {7, .001, 2}, {15, .0005, 0}}, {.03, .04}, .0005);
}

void evaluation(benchmark::State& state)
{
    const Profile profile = turned(state.range(0));
    form::RoundnessParameters parameters;
    if (state.range(1) > 0) parameters.cutoff_upr = static_cast<double>(state.range(1));
    for (auto _ : state) benchmark::DoNotOptimize(roundness(profile, parameters));
}
BENCHMARK(evaluation)
    ->ArgNames({"points", "cutoff"})
    ->Args({200, 0})
    ->Args({200, 15})
    ->Args({3600, 0})
    ->Args({3600, 50})
    ->Args({36000, 50})
    ->Args({1000000, 0})
    ->Args({1000000, 50})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Angles that are not at even steps: sums and fits instead of one transform.
void evaluationOfUnevenSteps(benchmark::State& state)
{
    const auto count = static_cast<std::size_t>(state.range(0));
    std::vector<double> angle = evenAngles(count);
    for (std::size_t i = 0; i < count; ++i)
        angle[i] += 0.6 * randomUniform(7, 0, i) * 2 * std::numbers::pi / static_cast<double>(count);
    const Profile profile = lobedProfile(angle, {{2, .003, 1}, {7, .001, 2}}, {.03, .04}, .0005);
    for (auto _ : state) benchmark::DoNotOptimize(roundness(profile));
}
BENCHMARK(evaluationOfUnevenSteps)->Arg(36000)->Arg(1000000)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Share of parts whose true RONt lies within the stated uncertainty, for each kind of noise at many points.
void coverage(benchmark::State& state)
{
    const NoiseCase kind = noiseCases()[static_cast<std::size_t>(state.range(0))];
    Coverage found;
    for (auto _ : state) found = coverageOf(kind, static_cast<std::size_t>(state.range(1)), 40);
    state.SetLabel(kind.name);
    state.counters["covered_percent"] = 100.0 * found.covered / found.runs;
    state.counters["U_um"] = found.uncertainty_um;
    state.counters["error_um"] = found.error_um;
}
BENCHMARK(coverage)
    ->ArgsProduct({benchmark::CreateDenseRange(0, 6, 1), {3600, 36000}})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

void filter(benchmark::State& state)
{
    form::PreparedProfile profile = prepareProfile(turned(state.range(0)), {}, form::OutlierRule::None);
    for (auto _ : state) benchmark::DoNotOptimize(evaluateProfile(profile, {{}, 50}));
}
BENCHMARK(filter)->Arg(200)->Arg(3600)->Arg(36000)->Unit(benchmark::kMillisecond);

void filterBesideKeyway(benchmark::State& state)
{
    form::PreparedProfile profile = prepareProfile(turned(state.range(0)), {{10, 18}}, form::OutlierRule::None);
    for (auto _ : state) benchmark::DoNotOptimize(evaluateProfile(profile, {{}, 50}));
}
BENCHMARK(filterBesideKeyway)->Arg(3600)->Arg(36000)->Unit(benchmark::kMillisecond);

void harmonics(benchmark::State& state)
{
    const form::PreparedProfile profile = prepareProfile(turned(state.range(0)), {}, form::OutlierRule::None);
    for (auto _ : state)
        benchmark::DoNotOptimize(signal::harmonicsAt(profile.sampling.angle_rad, profile.distance_mm, 500));
}
BENCHMARK(harmonics)->Arg(200)->Arg(3600)->Arg(36000)->Unit(benchmark::kMillisecond);

void superimposed(benchmark::State& state)
{
    const Profile first = turned(state.range(0)), second = turned(360);
    for (auto _ : state) benchmark::DoNotOptimize(superimpose(first, second));
}
BENCHMARK(superimposed)->Arg(200)->Arg(3600)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::form

BENCHMARK_MAIN();
