// Reading speed, warm: text cloud of 4 million points (about 110 MB) and the shared 732 k point PLY.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <random>

#include "engine/io/cloud/scan_reader.h"
#include "engine/io/file.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/sample/sample.h"
#include "engine/sample/sample_files.h"

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
    io::writeFile(path, makeText(4'000'000));
    const auto bytes = static_cast<double>(std::filesystem::file_size(path));
    for (auto _ : state) benchmark::DoNotOptimize(io::readScan(path).scan.points_mm.size());
    state.counters["MB"] = bytes / 1e6;
    state.counters["MB_per_s"] =
        benchmark::Counter(bytes / 1e6 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    std::filesystem::remove(path);
}
BENCHMARK(readTextFile)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// A raw record of five channels, 2 million frames (about 90 MB).
void readRecordFile(benchmark::State& state)
{
    const std::string path = (std::filesystem::temp_directory_path() / "lathelier_record_bench.csv").string();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> signal(-99, 99);
    std::string text = "t_s,marker_V,X3_um,Y3_um,Xp_um,Yp_um\n";
    char row[120];
    for (int i = 0; i < 2'000'000; ++i) {
        const double a = signal(random), b = signal(random), c = signal(random), d = signal(random);
        text.append(row, static_cast<std::size_t>(std::snprintf(row, sizeof(row), "%.7f,%.3f,%.3f,%.3f,%.3f,%.3f\n",
                                                                i / 6500.0, 0.5, a, b, c, d)));
    }
    io::writeFile(path, text);
    for (auto _ : state) benchmark::DoNotOptimize(io::readProbeRecord(path).facts.rows);
    state.counters["MB"] = static_cast<double>(text.size()) / 1e6;
    state.counters["MB_per_s"] = benchmark::Counter(
        static_cast<double>(text.size()) / 1e6 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    std::filesystem::remove(path);
}
BENCHMARK(readRecordFile)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void readPracticeRecord(benchmark::State& state)
{
    const std::string folder = LATHELIER_SOURCE_DIR "/tests/data/lagrang/";
    const char* const names[] = {"section01_raw.csv", "section01_lgraph1.dat", "averaged_20x200.csv"};
    const std::string path = folder + names[state.range(0)];
    for (auto _ : state) benchmark::DoNotOptimize(io::readProbeRecord(path).facts.rows);
    state.SetLabel(names[state.range(0)]);
}
BENCHMARK(readPracticeRecord)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond)->UseRealTime();

void readBinaryPly(benchmark::State& state)
{
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "lathelier-bench-sample";
    sample::writeSample(folder.string());
    const std::string path = (folder / "copy.ply").string();
    for (auto _ : state) benchmark::DoNotOptimize(io::readScan(path).scan.points_mm.size());
    std::filesystem::remove_all(folder);
}
BENCHMARK(readBinaryPly)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void digest(benchmark::State& state)
{
    const std::string text = makeText(1'000'000);
    for (auto _ : state) benchmark::DoNotOptimize(io::sha256(text));
    state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}
BENCHMARK(digest)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
