// From a scan to what the window's bar of questions says of it, with nothing else given: the limit is 10 s for the
// whole window.
#include <benchmark/benchmark.h>

#include <fstream>

#include "engine/walk/part_places.h"
#include "engine/walk/shop_supply.h"
#include "engine/walk/walk.h"
#include "tests/engine/features/made_scan.h"
#include "tests/scratch_folder.h"

namespace lathelier::walk {
namespace {

std::string slenderScan(const ScratchFolder& folder)
{
    const std::string path = (folder / "slender.xyz").string();
    const sample::ShaftModel shaft{features::piece(0, 60, 16, 16), features::piece(60, 140, 20, 20),
                                   features::piece(140, 180, 24, 24)};
    std::ofstream file(path);
    file.precision(9);
    for (const auto& point : sample::scanShaft(shaft, features::askew(7, 0.01)).points_mm)
        file << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
    return path;
}

/// Nothing is kept from one time to the next.
void BM_WalkFromAScan(benchmark::State& state)
{
    const ScratchFolder folder;
    project::Project project;
    project.panels["recognise"].inputs["scan"].path = slenderScan(folder);
    for (auto _ : state) {
        const Walk walk(project, partPlaces(), supplyOf({}), std::make_shared<Stores>());
        for (const char* id : {"drawing", "shaft", "lobes", "turning", "program", "deflection"})
            benchmark::DoNotOptimize(walk.answer(id, {}));
    }
}
BENCHMARK(BM_WalkFromAScan)->Unit(benchmark::kMillisecond)->UseRealTime();

/// What the window asks at every change: what would fill each input, without computing it.
void BM_WalkPromises(benchmark::State& state)
{
    const ScratchFolder folder;
    project::Project project;
    project.panels["recognise"].inputs["scan"].path = slenderScan(folder);
    const auto stores = std::make_shared<Stores>();
    for (auto _ : state) {
        const Walk walk(project, partPlaces(), supplyOf({}), stores);
        for (const Place& place : walk.places()) benchmark::DoNotOptimize(walk.digest(place.id));
    }
}
BENCHMARK(BM_WalkPromises)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::walk

BENCHMARK_MAIN();
