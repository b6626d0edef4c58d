// Photographs of turned surfaces: evaluating half a megapixel (1 s) and 12 megapixels (3 s).
#include <benchmark/benchmark.h>

#include "engine/surface/surface.h"
#include "engine/surface/synthetic.h"

namespace lathelier::surface {
namespace {

/// An overview of `across` px height on a part of 30 mm.
void findMarks(benchmark::State& state)
{
    SyntheticParameters made;
    made.width = static_cast<int>(state.range(0));
    made.height = static_cast<int>(state.range(1));
    made.cylinder = true;
    made.mm_per_px = 0.88 * made.diameter_mm / made.height;
    made.feed_mm_rev = 0.2;
    made.nose_radius_mm = 0.8;
    made.amplitude_um = 18;
    const NamedImage picture{"made", syntheticPicture(made)};
    SurfaceParameters p;
    p.feed_mm_rev = made.feed_mm_rev;
    p.diameter_mm = made.diameter_mm;
    p.mm_per_px = made.mm_per_px;
    p.speed_rpm = {{made.speed_rpm}};
    for (auto _ : state) benchmark::DoNotOptimize(findSurfaceMarks({picture}, p));
}
BENCHMARK(findMarks)->Args({570, 880})->Args({4000, 3000})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::surface

BENCHMARK_MAIN();
