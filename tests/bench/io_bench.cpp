// Reading speed, warm: text cloud of 4 million points (about 110 MB) and the shared 732 k point PLY.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <random>

#include "engine/io/file.h"
#include "engine/io/scan_reader.h"

namespace {

using namespace lathelier;

/// Rows such as "-12.34567 8.90123 45.67890".
std::string makeText(std::size_t points)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-99, 99);
    std::string text;
    char row[100];
    for (std::size_t i = 0; i < points; ++i) {
        const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
        text.append(row, static_cast<std::size_t>(std::snprintf(row, sizeof(row), "%.5f %.5f %.5f\n", x, y, z)));
    }
    return text;
}

void readTextFile(benchmark::State& state)
{
    const std::string path = (std::filesystem::temp_directory_path() / "lathelier_io_bench.xyz").string();
    writeFile(path, makeText(4'000'000));
    const auto bytes = static_cast<double>(std::filesystem::file_size(path));
    for (auto _ : state) benchmark::DoNotOptimize(readScan(path).scan.points_mm.size());
    state.counters["MB"] = bytes / 1e6;
    state.counters["MB_per_s"] =
        benchmark::Counter(bytes / 1e6 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    std::filesystem::remove(path);
}
BENCHMARK(readTextFile)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void readBinaryPly(benchmark::State& state)
{
    const std::string path = LATHELIER_SOURCE_DIR "/../shared/data/scans/shaft_copy.ply";
    if (!std::filesystem::exists(path)) {
        state.SkipWithError("no shared data");
        return;
    }
    for (auto _ : state) benchmark::DoNotOptimize(readScan(path).scan.points_mm.size());
}
BENCHMARK(readBinaryPly)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void digest(benchmark::State& state)
{
    const std::string text = makeText(1'000'000);
    for (auto _ : state) benchmark::DoNotOptimize(sha256(text));
    state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}
BENCHMARK(digest)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
